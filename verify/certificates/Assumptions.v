(* Prints the axioms on which the theorems rest. *)
From Edgeproof Require EQ01.
From Edgeproof Require EQ02_p.
From Edgeproof Require EQ02_g.
From Edgeproof Require EQ03.
From Edgeproof Require EQ05.
From Edgeproof Require EQ07_integrand.
From Edgeproof Require EQ07_integral.
From Edgeproof Require EQ08_L.
From Edgeproof Require EQ08_M.
From Edgeproof Require EQ08_N.
From Edgeproof Require EQ09_M.
From Edgeproof Require EQ09_N.
From Edgeproof Require EQ11.
From Edgeproof Require EQ12.
From Edgeproof Require EQ13_L.
From Edgeproof Require EQ13_M.
From Edgeproof Require EQ13_N.
From Edgeproof Require EQ14_L.
From Edgeproof Require EQ14_M.
From Edgeproof Require EQ14_N.
From Edgeproof Require EQ17_flat.
From Edgeproof Require EQ17_P.
From Edgeproof Require EQ18.
From Edgeproof Require EQ19_L.
From Edgeproof Require EQ19_M.
From Edgeproof Require EQ19_N.
From Edgeproof Require EQ20.
From Edgeproof Require EQ21_R.
From Edgeproof Require EQ21_L.
From Edgeproof Require EQ22_P.
From Edgeproof Require EQ23_L.
From Edgeproof Require EQ23_M.
From Edgeproof Require EQ23_N.
From Edgeproof Require EQ24_L.
From Edgeproof Require EQ24_M.
From Edgeproof Require EQ24_N.
From Edgeproof Require EQ25_L.
From Edgeproof Require EQ25_M.
From Edgeproof Require EQ25_N.
From Edgeproof Require EQ27.
From Edgeproof Require EQ28_b.
From Edgeproof Require EQ28_P.
From Edgeproof Require EQ28_gamma.
From Edgeproof Require EQ30_L.
From Edgeproof Require EQ30_M.
From Edgeproof Require EQ30_N.
From Edgeproof Require EQ32_L.
From Edgeproof Require EQ32_M.
From Edgeproof Require EQ32_N.
From Edgeproof Require EQ34_q.
From Edgeproof Require EQ34_force.
From Edgeproof Require EQ34_strain.
From Edgeproof Require EQ35.
From Edgeproof Require EQ36_K.
From Edgeproof Require EQ36_L.
From Edgeproof Require EQ36_M.
From Edgeproof Require EQ37_K.
From Edgeproof Require EQ37_L.
From Edgeproof Require EQ37_M.
From Edgeproof Require EQ39_Kplus.
From Edgeproof Require EQ39_Lplus.
From Edgeproof Require EQ39_Mplus.
From Edgeproof Require EQ39_Kminus.
From Edgeproof Require EQ39_Lminus.
From Edgeproof Require EQ39_Mminus.
From Edgeproof Require EQ41.
From Edgeproof Require EQ44.
From Edgeproof Require EQ45.
From Edgeproof Require EQ47_F.
From Edgeproof Require EQ47_last.
From Edgeproof Require EQ48.
From Edgeproof Require S38_origin.
From Edgeproof Require S38_sides.
From Edgeproof Require S45.
From Edgeproof Require EQ38_Lplus.
From Edgeproof Require EQ38_Lminus.
From Edgeproof Require EQ40.
From Edgeproof Require S49.
From Edgeproof Require S50_right.
From Edgeproof Require S50_left.
From Edgeproof Require S51_left.
From Edgeproof Require S51_right.
From Edgeproof Require S51_subtractive.
From Edgeproof Require S53_force.
From Edgeproof Require S53_tension.
From Edgeproof Require S53_equation.
From Edgeproof Require S54_right.
From Edgeproof Require S54_left.
From Edgeproof Require S54_stick.
From Edgeproof Require S47_right.
From Edgeproof Require S47_left.
From Edgeproof Require S48_right.
From Edgeproof Require S48_left.
From Edgeproof Require S52_force.
From Edgeproof Require S52_tension.
From Edgeproof Require S52_together.
From Edgeproof Require S55.
From Edgeproof Require EQ04_right.
From Edgeproof Require EQ04_left.
From Edgeproof Require EQ29.
From Edgeproof Require EQ31.
From Edgeproof Require S01.
From Edgeproof Require S02.
From Edgeproof Require S03_M.
From Edgeproof Require S03_N.
From Edgeproof Require S04_distance.
From Edgeproof Require S04_flatness.
From Edgeproof Require S05_diverges.
From Edgeproof Require S05_punch.
From Edgeproof Require S06.
From Edgeproof Require S07.
From Edgeproof Require S10.
From Edgeproof Require S11.
From Edgeproof Require S12.
From Edgeproof Require S13.
From Edgeproof Require S14.
From Edgeproof Require S15.
From Edgeproof Require S16.
From Edgeproof Require S17_wedge.
From Edgeproof Require S17_hertz.
From Edgeproof Require S18_none.
From Edgeproof Require S18_any.
From Edgeproof Require S18_limit.
From Edgeproof Require S19_continuous.
From Edgeproof Require S19_peak.
From Edgeproof Require S19_minimum.
From Edgeproof Require S20.
From Edgeproof Require S21.
From Edgeproof Require S22.
From Edgeproof Require S23.
From Edgeproof Require S24.
From Edgeproof Require S25.
From Edgeproof Require S26.
From Edgeproof Require S28_L.
From Edgeproof Require S28_M.
From Edgeproof Require S28_N.
From Edgeproof Require S29_L.
From Edgeproof Require S29_M.
From Edgeproof Require S29_N.
From Edgeproof Require S30.
From Edgeproof Require S31_range.
From Edgeproof Require S31_one.
From Edgeproof Require S31_zero.
From Edgeproof Require S32.
From Edgeproof Require S33.
From Edgeproof Require S34.
From Edgeproof Require S35.
From Edgeproof Require S36.
From Edgeproof Require S37_right.
From Edgeproof Require S37_left.
From Edgeproof Require S60_wedge.
From Edgeproof Require S60_hertz.
From Edgeproof Require S61.

Definition all_theorems : True :=
  let _ := EQ01.EQ01 in
  let _ := EQ02_p.EQ02_p in
  let _ := EQ02_g.EQ02_g in
  let _ := EQ03.EQ03 in
  let _ := EQ05.EQ05 in
  let _ := EQ07_integrand.EQ07_integrand_refuted in
  let _ := EQ07_integrand.EQ07_integrand_corrected in
  let _ := EQ07_integrand.EQ07_integrand_instance in
  let _ := EQ07_integral.EQ07_integral_refuted in
  let _ := EQ07_integral.EQ07_integral_corrected in
  let _ := EQ07_integral.EQ07_integral_instance in
  let _ := EQ08_L.EQ08_L in
  let _ := EQ08_M.EQ08_M in
  let _ := EQ08_N.EQ08_N in
  let _ := EQ09_M.EQ09_M in
  let _ := EQ09_N.EQ09_N in
  let _ := EQ11.EQ11 in
  let _ := EQ12.EQ12 in
  let _ := EQ13_L.EQ13_L in
  let _ := EQ13_M.EQ13_M in
  let _ := EQ13_N.EQ13_N in
  let _ := EQ14_L.EQ14_L in
  let _ := EQ14_M.EQ14_M in
  let _ := EQ14_N.EQ14_N in
  let _ := EQ17_flat.EQ17_flat in
  let _ := EQ17_P.EQ17_P in
  let _ := EQ18.EQ18_refuted in
  let _ := EQ18.EQ18_corrected in
  let _ := EQ19_L.EQ19_L in
  let _ := EQ19_M.EQ19_M in
  let _ := EQ19_N.EQ19_N in
  let _ := EQ20.EQ20 in
  let _ := EQ21_R.EQ21_R in
  let _ := EQ21_L.EQ21_L in
  let _ := EQ22_P.EQ22_P in
  let _ := EQ23_L.EQ23_L in
  let _ := EQ23_M.EQ23_M in
  let _ := EQ23_N.EQ23_N in
  let _ := EQ24_L.EQ24_L in
  let _ := EQ24_M.EQ24_M in
  let _ := EQ24_N.EQ24_N in
  let _ := EQ25_L.EQ25_L in
  let _ := EQ25_M.EQ25_M in
  let _ := EQ25_N.EQ25_N in
  let _ := EQ27.EQ27_refuted in
  let _ := EQ27.EQ27_corrected in
  let _ := EQ28_b.EQ28_b in
  let _ := EQ28_P.EQ28_P in
  let _ := EQ28_gamma.EQ28_gamma in
  let _ := EQ30_L.EQ30_L_refuted in
  let _ := EQ30_L.EQ30_L_corrected in
  let _ := EQ30_M.EQ30_M_refuted in
  let _ := EQ30_M.EQ30_M_corrected in
  let _ := EQ30_N.EQ30_N_refuted in
  let _ := EQ30_N.EQ30_N_corrected in
  let _ := EQ32_L.EQ32_L_refuted in
  let _ := EQ32_L.EQ32_L_corrected in
  let _ := EQ32_M.EQ32_M_refuted in
  let _ := EQ32_M.EQ32_M_corrected in
  let _ := EQ32_N.EQ32_N_refuted in
  let _ := EQ32_N.EQ32_N_corrected in
  let _ := EQ34_q.EQ34_q in
  let _ := EQ34_force.EQ34_force in
  let _ := EQ34_strain.EQ34_strain in
  let _ := EQ35.EQ35 in
  let _ := EQ36_K.EQ36_K in
  let _ := EQ36_L.EQ36_L in
  let _ := EQ36_M.EQ36_M in
  let _ := EQ37_K.EQ37_K in
  let _ := EQ37_L.EQ37_L in
  let _ := EQ37_M.EQ37_M in
  let _ := EQ39_Kplus.EQ39_Kplus in
  let _ := EQ39_Lplus.EQ39_Lplus in
  let _ := EQ39_Mplus.EQ39_Mplus in
  let _ := EQ39_Kminus.EQ39_Kminus in
  let _ := EQ39_Lminus.EQ39_Lminus in
  let _ := EQ39_Mminus.EQ39_Mminus in
  let _ := EQ41.EQ41 in
  let _ := EQ44.EQ44_refuted in
  let _ := EQ44.EQ44_corrected in
  let _ := EQ44.EQ44_instance in
  let _ := EQ45.EQ45_refuted_1 in
  let _ := EQ45.EQ45_corrected_1 in
  let _ := EQ45.EQ45_instance_1 in
  let _ := EQ45.EQ45_refuted_2 in
  let _ := EQ45.EQ45_corrected_2 in
  let _ := EQ45.EQ45_instance_2 in
  let _ := EQ47_F.EQ47_F in
  let _ := EQ47_last.EQ47_last_refuted_1 in
  let _ := EQ47_last.EQ47_last_corrected_1 in
  let _ := EQ47_last.EQ47_last_instance_1 in
  let _ := EQ47_last.EQ47_last_refuted_2 in
  let _ := EQ47_last.EQ47_last_corrected_2 in
  let _ := EQ47_last.EQ47_last_instance_2 in
  let _ := EQ48.EQ48_refuted_1 in
  let _ := EQ48.EQ48_corrected_1 in
  let _ := EQ48.EQ48_instance_1 in
  let _ := EQ48.EQ48_refuted_2 in
  let _ := EQ48.EQ48_corrected_2 in
  let _ := EQ48.EQ48_instance_2 in
  let _ := S38_origin.S38_origin in
  let _ := S38_sides.S38_sides in
  let _ := S45.S45 in
  let _ := EQ38_Lplus.EQ38_Lplus_refuted in
  let _ := EQ38_Lminus.EQ38_Lminus_refuted in
  let _ := EQ40.EQ40 in
  let _ := S49.S49_refuted in
  let _ := S49.S49_corrected in
  let _ := S50_right.S50_right in
  let _ := S50_left.S50_left in
  let _ := S51_left.S51_left in
  let _ := S51_right.S51_right in
  let _ := S51_subtractive.S51_subtractive in
  let _ := S53_force.S53_force in
  let _ := S53_tension.S53_tension in
  let _ := S53_equation.S53_equation in
  let _ := S54_right.S54_right in
  let _ := S54_left.S54_left in
  let _ := S54_stick.S54_stick in
  let _ := S47_right.S47_right in
  let _ := S47_left.S47_left in
  let _ := S48_right.S48_right_1 in
  let _ := S48_right.S48_right_2 in
  let _ := S48_left.S48_left_1 in
  let _ := S48_left.S48_left_2 in
  let _ := S52_force.S52_force in
  let _ := S52_tension.S52_tension in
  let _ := S52_together.S52_together in
  let _ := S55.S55_refuted in
  let _ := EQ04_right.EQ04_right in
  let _ := EQ04_left.EQ04_left in
  let _ := EQ29.EQ29 in
  let _ := EQ31.EQ31 in
  let _ := S01.S01 in
  let _ := S02.S02 in
  let _ := S03_M.S03_M_refuted in
  let _ := S03_N.S03_N_refuted in
  let _ := S04_distance.S04_distance_refuted in
  let _ := S04_flatness.S04_flatness_refuted in
  let _ := S05_diverges.S05_diverges in
  let _ := S05_punch.S05_punch in
  let _ := S06.S06_1 in
  let _ := S06.S06_2 in
  let _ := S07.S07_1 in
  let _ := S07.S07_2 in
  let _ := S10.S10_figure in
  let _ := S10.S10_figure_similar in
  let _ := S11.S11_figure in
  let _ := S11.S11_figure_similar in
  let _ := S12.S12 in
  let _ := S12.S12_derived in
  let _ := S13.S13_extent in
  let _ := S13.S13_extent_similar in
  let _ := S14.S14_extent in
  let _ := S14.S14_extent_similar in
  let _ := S15.S15_extent in
  let _ := S15.S15_extent_similar in
  let _ := S16.S16_extent in
  let _ := S16.S16_extent_similar in
  let _ := S17_wedge.S17_wedge in
  let _ := S17_hertz.S17_hertz in
  let _ := S18_none.S18_none in
  let _ := S18_any.S18_any in
  let _ := S18_limit.S18_limit in
  let _ := S19_continuous.S19_continuous in
  let _ := S19_peak.S19_peak in
  let _ := S19_minimum.S19_minimum in
  let _ := S20.S20_extent in
  let _ := S20.S20_extent_similar in
  let _ := S21.S21_extent in
  let _ := S21.S21_extent_similar in
  let _ := S22.S22_extent in
  let _ := S22.S22_extent_similar in
  let _ := S23.S23_extent in
  let _ := S23.S23_extent_similar in
  let _ := S24.S24_extent in
  let _ := S24.S24_extent_similar in
  let _ := S25.S25_extent in
  let _ := S25.S25_extent_similar in
  let _ := S26.S26 in
  let _ := S28_L.S28_L in
  let _ := S28_M.S28_M in
  let _ := S28_N.S28_N in
  let _ := S29_L.S29_L in
  let _ := S29_M.S29_M in
  let _ := S29_N.S29_N in
  let _ := S30.S30 in
  let _ := S31_range.S31_range in
  let _ := S31_one.S31_one in
  let _ := S31_zero.S31_zero in
  let _ := S32.S32_figure in
  let _ := S33.S33_extent in
  let _ := S34.S34_extent in
  let _ := S35.S35_extent in
  let _ := S35.S35_extent_3 in
  let _ := S35.Reading_4.S35_extent_4 in
  let _ := S36.S36_extent in
  let _ := S37_right.S37_right in
  let _ := S37_left.S37_left in
  let _ := S60_wedge.S60_wedge in
  let _ := S60_hertz.S60_hertz in
  let _ := S61.S61 in
  I.
Print Assumptions all_theorems.
