// SPDX-License-Identifier: BSD-3-Clause
// Boost.Math's tanh-sinh in several arithmetics. Reads lines of id family digits u m t K W (a =
// 1; decimals), writes id, value, evaluations, seconds for a value (of the processor, median of the
// repeats). The arithmetic is mpfr_float of run-time precision; with -DSTATIC mpfr_float of 50 and
// 100 digits, with -DCPP_BIN_FLOAT cpp_bin_float of 50 and 100 digits only. The tolerance is the
// default, which gives full digits.
//
// The substitution s^2 = x^2 + w^2 removes the singularity at s = x (for x below the end of the
// flat: s = t/cos(phi)); x and 1 - x^2 are computed from u, so that nothing cancels at the end
// points. There is one integrator for each precision.
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace mp = boost::multiprecision;

static double seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Question {
    std::string id, family, u, m, t, K;
    unsigned digits;
};

template <class T> class Pressure {
public:
    Pressure(const Question& q, boost::math::quadrature::tanh_sinh<T>& rule)
        : rule_(rule), flat_(q.family == "flat"), u_(q.u), t_(q.t), factor_(T(q.K)),
          exponent_((T(q.m) - 1) / 2), root_(exponent_ == T(0.5)), x_(1 - u_) {
        factor_ /= boost::math::constants::pi<T>();
    }
    T operator()() {
        using std::acos;
        using std::cos;
        using std::pow;
        using std::sin;
        using std::sqrt;
        evaluations = 0;
        if (flat_ && x_ < t_) {
            const T end = acos(t_);
            return factor_ * t_ * t_ *
                   rule_.integrate(
                       [&](const T& phi) -> T {
                           ++evaluations;
                           const T c = cos(phi);
                           const T c2 = c * c;
                           return phi * sin(phi) / (c2 * sqrt(t_ * t_ - x_ * x_ * c2));
                       },
                       T(0), end);
        }
        const T end = sqrt(T(u_ * (2 - u_)));
        const T x2 = x_ * x_;
        if (flat_) {
            return factor_ * rule_.integrate(
                                 [&](const T& w) -> T {
                                     ++evaluations;
                                     return acos(T(t_ / sqrt(T(x2 + w * w))));
                                 },
                                 T(0), end);
        }
        return factor_ * rule_.integrate(
                             [&](const T& w) -> T {
                                 ++evaluations;
                                 const T square = x2 + w * w;
                                 return root_ ? T(sqrt(square)) : T(pow(square, exponent_));
                             },
                             T(0), end);
    }
    long evaluations = 0;

private:
    boost::math::quadrature::tanh_sinh<T>& rule_;
    bool flat_;
    T u_, t_, factor_, exponent_;
    bool root_;
    T x_;
};

template <class T> static void answer(const Question& q, double enough) {
    static std::map<unsigned, std::unique_ptr<boost::math::quadrature::tanh_sinh<T>>> rules;
    auto& rule = rules[q.digits];
    if (!rule) {
        rule = std::make_unique<boost::math::quadrature::tanh_sinh<T>>();
    }
    try {
        Pressure<T> pressure(q, *rule);
        T p = pressure();
        std::vector<double> times;
        double spent = 0;
        do {
            const double begun = seconds();
            p = pressure();
            times.push_back(seconds() - begun);
            spent += times.back();
        } while (spent < enough && times.size() < 64);
        std::sort(times.begin(), times.end());
        std::cout << q.id << ' ' << std::setprecision(static_cast<int>(q.digits) + 5) << p << ' '
                  << pressure.evaluations << ' ' << std::setprecision(6) << times[times.size() / 2]
                  << std::endl;
    } catch (const std::exception& e) {
        std::cout << q.id << " none " << e.what() << std::endl;
    }
}

// One arithmetic for each program: each takes half a minute to compile.
#if defined(STATIC)
template <unsigned D> using Number = mp::number<mp::mpfr_float_backend<D>, mp::et_off>;
#elif defined(CPP_BIN_FLOAT)
template <unsigned D> using Number = mp::number<mp::cpp_bin_float<D>, mp::et_off>;
#endif

int main(int argc, char** argv) {
    const double enough = argc > 1 ? std::atof(argv[1]) : 5e-3;
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream in(line);
        Question q;
        if (!(in >> q.id >> q.family >> q.digits >> q.u >> q.m >> q.t >> q.K)) {
            continue;
        }
#if defined(STATIC) || defined(CPP_BIN_FLOAT)
        if (q.digits == 50) {
            answer<Number<53>>(q, enough);
        } else if (q.digits == 100) {
            answer<Number<103>>(q, enough);
        }
#else
        using T = mp::number<mp::mpfr_float_backend<0>, mp::et_off>;
        T::default_precision(q.digits + 3);
        answer<T>(q, enough);
#endif
    }
    return 0;
}
