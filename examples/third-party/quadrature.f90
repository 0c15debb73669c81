! SPDX-License-Identifier: BSD-3-Clause
! Answers the questions of `edgeproof points` by quadrature in real*8, without closed forms:
!
!     gfortran -O2 -o quadrature quadrature.f90
!     edgeproof check questions.toml --exec ./quadrature --digits 13
!
! Symmetric profiles of slope g'(x) at x > 0. The force that a half-width s carries, and the
! pressure (Barber-Mossakovskii), with s = x cosh(y):
!     P(s) = E* integral_0^(pi/2) s sin(th) g'(s sin th) dth,    p(x) = 1/pi integral P'(s) dy.
program quadrature
  implicit none
  integer, parameter :: dp = kind(1d0), nodes = 40, longest = 65536, most = 64
  real(dp), parameter :: pi = acos(-1d0)
  real(dp) :: at(nodes), weight(nodes), a, u, modulus, slope, t, m
  character(len=longest) :: line
  character(len=1024) :: names(most), cells(most)
  logical :: flat
  integer :: status, columns, found

  call gauss_legendre()
  columns = 0
  do
    read (*, '(a)', iostat=status) line
    if (status /= 0) exit
    if (line(1:1) == '#' .or. len_trim(line) == 0) cycle
    if (columns == 0) then
      call split(names, columns)
      print '(a)', 'id,value'
      cycle
    end if
    call split(cells, found)
    flat = text('kind') == 'flat-and-rounded'
    a = number('a'); u = number('u'); m = number('m'); t = 0
    modulus = number('contact_modulus')
    slope = number('C')
    if (flat) then
      t = number('t'); slope = 1/number('R'); m = 1
    end if
    print '(a,",",es24.16)', trim(text('id')), answer(trim(text('quantity')))
  end do

contains

  real(dp) function answer(name)
    character(len=*), intent(in) :: name
    real(dp) :: x, ends(2), second
    select case (name)
    case ('P')
      answer = force(a, a*a - t*t)
    case ('c_0')
      answer = rate(a, a*a - t*t)/pi*sqrt(2/a)
    case ('c_1')  ! of the cylinder alone: P'' = E* C integral of 2 sin^2
      second = modulus*slope*pi/2
      answer = 2*sqrt(2d0)/(3*a*sqrt(a)*pi)*(5*rate(a, a*a)/8 - a*second)
    case default
      x = abs(a - u)
      ends = [0d0, asinh(sqrt(u*(2*a - u))/x)]
      if (t > x) ends(1) = acosh(t/x)
      answer = tanh_sinh(x, ends)/pi
    end select
  end function answer

  ! P(s) and P'(s); d is s^2 - t^2, without cancellation.
  real(dp) function force(s, d)
    real(dp), intent(in) :: s, d
    real(dp) :: width, st
    integer :: i
    width = atan2(sqrt(d), t)
    force = 0
    do i = 1, nodes
      st = cos(width*at(i))  ! sin(th), th from the middle out
      force = force + weight(i)*s*st*slope*merge(s*st - t, 1d0, m > 0)
    end do
    force = modulus*force*width
  end function force

  real(dp) function rate(s, d)
    real(dp), intent(in) :: s, d
    real(dp) :: width, st
    integer :: i
    width = atan2(sqrt(d), t)
    rate = 0
    do i = 1, nodes
      st = cos(width*at(i))
      rate = rate + weight(i)*slope*st*merge(2*s*st - t, 1d0, m > 0)
    end do
    rate = modulus*rate*width
  end function rate

  ! integral of P'(x cosh y) over y; P' is as a square root at the end of a flat.
  real(dp) function tanh_sinh(x, ends)
    real(dp), intent(in) :: x, ends(2)
    real(dp), parameter :: step = 1d0/32
    real(dp) :: length, k, below, d, y
    integer :: j
    length = ends(2) - ends(1)
    tanh_sinh = 0
    do j = -112, 112
      k = pi/2*sinh(j*step)
      below = length/(1 + exp(-2*k))  ! y - ends(1)
      y = ends(1) + below
      d = x*x*sinh(below)*sinh(below + 2*ends(1))
      if (t < x) d = x*x*cosh(y)**2 - t*t
      tanh_sinh = tanh_sinh + cosh(j*step)/cosh(k)**2*rate(x*cosh(y), d)
    end do
    tanh_sinh = tanh_sinh*step*pi/4*length
  end function tanh_sinh

  ! Nodes and weights on 0 ... 1.
  subroutine gauss_legendre()
    real(dp) :: z, p0, p1, p2, slope_p
    integer :: i, j, k
    do i = 1, nodes
      z = cos(pi*(i - 0.25d0)/(nodes + 0.5d0))
      do k = 1, 20
        p0 = 1; p1 = z
        do j = 2, nodes
          p2 = ((2*j - 1)*z*p1 - (j - 1)*p0)/j
          p0 = p1; p1 = p2
        end do
        slope_p = nodes*(z*p1 - p0)/(z*z - 1)
        z = z - p1/slope_p
      end do
      at(i) = (1 + z)/2
      weight(i) = 1/((1 - z*z)*slope_p**2)
    end do
  end subroutine gauss_legendre

  subroutine split(cell, count)
    character(len=*), intent(out) :: cell(:)
    integer, intent(out) :: count
    integer :: from, comma
    cell = ''
    count = 0
    from = 1
    do
      comma = index(line(from:), ',')
      count = count + 1
      if (comma == 0) then
        cell(count) = line(from:)
        return
      end if
      cell(count) = line(from:from + comma - 2)
      from = from + comma
    end do
  end subroutine split

  function text(name)
    character(len=*), intent(in) :: name
    character(len=1024) :: text
    integer :: i
    text = ''
    do i = 1, columns
      if (names(i) == name) text = cells(i)
    end do
  end function text

  real(dp) function number(name)
    character(len=*), intent(in) :: name
    character(len=1024) :: written
    integer :: failed
    written = text(name)
    read (written, *, iostat=failed) number
    if (failed /= 0) number = 0
  end function number
end program quadrature
