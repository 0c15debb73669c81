! SPDX-License-Identifier: BSD-3-Clause
! Holds a contact code against the conformance pack (Fortran 2008).
!
!     gfortran -O2 -o driver edgeproof_case.f90 example.f90 driver.f90   (yours for example.f90)
!     ./driver A level-a.csv
!     ./driver B cases.csv hard-cases.csv
!
! Levels A, B and C; README.md says what they ask. Exit status 0: every answer is within the level;
! 1: one is not; 2: there was nothing to hold.
program driver
    use edgeproof_case
    use edgeproof_answers
    implicit none
    integer, parameter :: columns = 24, most_shown = 10
    real(binary64), parameter :: same_ratio = 0.01d0 ! ratios that agree to this are one factor
    ! Wrong answers by the first letter of the quantity: their number, and the range of answer/exact.
    integer :: wrong_rows(0:127) = 0
    real(binary64) :: low(0:127) = huge(1d0), high(0:127) = -huge(1d0)
    character(len=*), parameter :: header = 'id,kind,m,C,phi,alpha,t,R,a,P,M,E,Q,S,edge,u,' // &
        'quantity,scale,value,bound,binary64,hex,condition,ulps'
    character(len=256) :: argument
    character(len=1) :: level
    integer :: i, answered, wrong, not_there
    answered = 0
    wrong = 0
    not_there = 0
    call get_command_argument(1, argument)
    level = argument(1:1)
    if (command_argument_count() < 2 .or. len_trim(argument) /= 1 .or. index('ABC', level) == 0) then
        print '(a)', 'usage: driver A|B|C FILE...'
        stop 2
    end if
    do i = 2, command_argument_count()
        call get_command_argument(i, argument)
        call hold_file(trim(argument))
    end do
    print '(a,a,a,i0,a,i0,a,i0,a)', 'level ', level, ': ', answered, ' answered, ', wrong, &
        ' wrong, ', not_there, ' not answered'
    call print_causes()
    if (wrong > 0) stop 1
    if (answered == 0) stop 2
contains
    subroutine hold_file(name)
        character(len=*), intent(in) :: name
        character(len=2048) :: line
        integer :: unit, status, rows, stated
        logical :: in_rows
        open (newunit=unit, file=name, status='old', action='read', iostat=status)
        if (status /= 0) then
            print '(a,a)', name, ': cannot be read'
            stop 2
        end if
        in_rows = .false.
        rows = 0
        stated = -1
        do
            read (unit, '(a)', iostat=status) line
            if (status /= 0) exit
            if (line(1:8) == '# rows: ') read (line(9:), *, iostat=status) stated
            if (line(1:1) == '#') cycle
            if (.not. in_rows) then
                if (trim(line) /= header) then
                    print '(a,a)', name, ': the columns are those of another pack'
                    stop 2
                end if
                in_rows = .true.
                cycle
            end if
            rows = rows + 1
            call hold_row(trim(line))
        end do
        close (unit)
        if (rows /= stated) then
            print '(a,a,i0,a)', name, ': the file is not whole: it has ', rows, &
                ' rows, and its line # rows has another number'
            stop 2
        end if
    end subroutine hold_file

    subroutine hold_row(line)
        character(len=*), intent(in) :: line
        character(len=160) :: cell(columns)
        type(question) :: c
        real(binary64) :: exact, value
        logical :: there
        integer :: k, at, comma
        at = 1
        do k = 1, columns
            comma = index(line(at:), ',')
            if (comma == 0) comma = len(line) - at + 2
            cell(k) = line(at:at + comma - 2)
            at = at + comma
            if (at > len(line) + 1 .and. k < columns) then
                print '(a)', 'a row is cut off'
                stop 2
            end if
        end do
        c%id = cell(1)
        c%kind = cell(2)(1:32)
        c%m = number(cell(3))
        c%C = number(cell(4))
        c%phi = number(cell(5))
        c%alpha = number(cell(6))
        c%t = number(cell(7))
        c%R = number(cell(8))
        c%a = number(cell(9))
        c%P = number(cell(10))
        c%Mom = number(cell(11))
        c%E = number(cell(12))
        c%Q = number(cell(13))
        c%S = number(cell(14))
        c%edge = cell(15)(1:8)
        c%u = number(cell(16))
        c%quantity = cell(17)(1:16)
        exact = number(cell(21))
        call edgeproof_answer(c, value, there)
        if (.not. there) then
            not_there = not_there + 1
            return
        end if
        answered = answered + 1
        if (.not. within(value, exact, number(cell(18)), number(cell(24)))) then
            wrong = wrong + 1
            k = iachar(c%quantity(1:1))
            wrong_rows(k) = wrong_rows(k) + 1
            low(k) = min(low(k), value/exact)
            high(k) = max(high(k), value/exact)
            if (value /= value) high(k) = huge(1d0)
            if (wrong <= most_shown) then
                print '(a,a,es24.16e3,a,es24.16e3)', trim(c%id), ': ', value, ', exact ', exact
            end if
        end if
    end subroutine hold_row

    ! Names the factor where all wrong answers of a quantity, three or more, have the same one.
    subroutine print_causes()
        character(len=64) :: name
        character(len=128) :: line, names
        real(binary64) :: middle, value
        integer :: k, unit, status
        do k = 0, 127
            middle = low(k)/2 + high(k)/2
            if (wrong_rows(k) < 3) cycle
            if (high(k)/2 - low(k)/2 > same_ratio*abs(middle)/2 .or. abs(middle - 1) <= same_ratio) cycle
            names = ''
            open (newunit=unit, file='factors.txt', status='old', action='read', iostat=status)
            do while (status == 0)
                read (unit, '(a)', iostat=status) line
                if (status /= 0 .or. line(1:1) == '#') cycle
                read (line, *, iostat=status) name, value
                if (status /= 0) exit
                if (abs(middle/value - 1) > same_ratio) cycle
                if (names /= '') names = trim(names)//' or '
                names = trim(names)//' '//trim(name)
            end do
            close (unit, iostat=status)
            if (names == '') names = ' factor'
            print '(a,i0,4a,g0.6,2a)', 'likely cause: the ', wrong_rows(k), ' wrong answers for ', &
                achar(k), ' are', ' ', middle, ' times the exact ones:', trim(names)
        end do
    end subroutine print_causes

    real(binary64) function number(text)
        character(len=*), intent(in) :: text
        read (text, *) number
    end function number

    ! Whether an answer is within the level: a NaN is not.
    logical function within(value, exact, scale, ulps)
        real(binary64), intent(in) :: value, exact, scale, ulps
        select case (level)
        case ('A')
            within = abs(value - exact) <= 0.01d0*scale
        case ('B')
            within = abs(value - exact) <= ulps*spacing(exact)
        case default
            within = value == exact
        end select
    end function within
end program driver
