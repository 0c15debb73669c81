// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/report/figures/figures.hpp"

#include <string>
#include <string_view>
#include <vector>

/// What the drawings of curves and of contours share. Lengths are in pixels.
namespace edgeproof::report::svg {

inline constexpr int left_margin = 74;
inline constexpr int top_margin = 34;
inline constexpr int drawing_height = 320;

inline constexpr int smallest_text = 10;
inline constexpr int usual_ticks = 6;

/// A text in SVG. `anchor` is start, middle or end.
[[nodiscard]] std::string text_at(double x, double y, std::string_view anchor, int size,
                                  const std::string& escaped);
/// A position in SVG: with a tenth of a pixel, and never -0.
[[nodiscard]] std::string number(double pixels);

/// A scale of an axis: its range, and the position of a value as a part of the length.
class Scale {
public:
    /// `values` are the data, from which the ends are taken if the axis has none. With `to_ticks`
    /// they are then moved outwards to the next tick. Throws Error without any value.
    Scale(const Axis& axis, const std::vector<Real>& values, bool to_ticks);

    /// Returns 0 at the low end and 1 at the high one.
    [[nodiscard]] Real part(const Real& value) const;
    [[nodiscard]] bool has(const Real& value) const { return !logarithmic_ || value > 0; }

    struct Tick {
        Real part;
        Real value;
        std::string label; ///< as SVG
    };
    /// About `most` ticks, or fewer.
    [[nodiscard]] std::vector<Tick> ticks(int most = usual_ticks) const;

private:
    [[nodiscard]] Real on_scale(const Real& value) const;
    [[nodiscard]] Real step(int most) const;

    bool logarithmic_;
    Real low_;
    Real high_;
};

/// The frame, the grid, the ticks and the labels of a drawing of the given size.
[[nodiscard]] std::string axes(const Scale& x, const Scale& y, const Plot& plot, int width,
                               int height, bool downwards);

/// A panel with the contours of plot.field, as wide as asked for (pixels), and its height.
struct Panel {
    std::string text;
    int height;
};
/// Throws Error for a field without a finite value.
[[nodiscard]] Panel contours(const Plot& plot, int width);

} // namespace edgeproof::report::svg
