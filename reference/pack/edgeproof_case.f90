! SPDX-License-Identifier: BSD-3-Clause
! A question of the conformance pack. README.md explains it.
module edgeproof_case
    implicit none
    integer, parameter :: binary64 = kind(1d0)
    type :: question
        character(len=160) :: id
        character(len=32) :: kind     ! power-law, flat-and-rounded, tilted-wedge, ...
        character(len=8) :: edge      ! right, left, none
        character(len=16) :: quantity ! p, q, c_0, s_0, ..., a, b, P, M, alpha
        ! NaN where the contact has none of that name.
        real(binary64) :: m, C, phi, alpha, t, R, a, P, Mom, E, Q, S
        real(binary64) :: u           ! distance inwards from the edge
    end type question
end module edgeproof_case
