\\ SPDX-License-Identifier: GPL-3.0-or-later
\\ PARI's intnum, used as in its manual. Reads lines of id digits kind a u K m t gamma from
\\ descriptor 3 (gp reads commands from standard input) and writes id, p and the absolute error
\\ that its user expects. intnum returns no error, so that its user expects that of the precision.
\\ With s as the variable it stops with a division by zero; hence v = s - x, and [0, -1/2].
rate(kind, K, m, t, s) = if(kind == "flat", K*s*acos(t/s), K*s^m);
pressure(kind, a, u, K, m, t, g) =
{
  my(x = a - u);
  if(kind == "flat" && x < t,
    intnum(s = t, a, rate(kind, K, m, t, s)/sqrt((s - x)*(x + g*s)))/Pi,
    intnum(v = [0, -1/2], a - x, rate(kind, K, m, t, x + v)/sqrt(v*(x + g*(x + v))))/Pi);
};
\\ gp writes "1.5 e-51".
text(format, x) = strjoin(strsplit(strprintf(format, x), " "));
answer(line) =
{
  my(w = strsplit(line, " "), n, p);
  default(realprecision, eval(w[2]));
  n = vector(6, k, 1.*eval(w[k + 3]));
  p = pressure(w[3], n[1], n[2], n[3], n[4], n[5], n[6]);
  if(imag(p) == 0,
    print(w[1], " ", text("%.60g", p), " ", text("%.5g", abs(p)*10.^(-eval(w[2])))));
};
lines = readstr("/dev/fd/3");
for(i = 1, #lines, iferr(answer(lines[i]), e, ));
