// SPDX-License-Identifier: MIT
// A small sans-serif font of strokes, drawn for this library, so that pictures need no font file.
//
// A glyph is written as strokes on a square grid. Heights: descender 0, baseline 3, top of small letters 9, of capitals C (12).
// A point is two base-36 digits, x then y. A stroke begins with its kind:
//   -  straight lines through the points
//   ~  a curve: quadratic B-spline of the points, clamped at both ends
//   o  a closed curve: the same without ends; the four corners of a rectangle give its rounded inscribed oval
//   .  a dot at each point
// Known: ASCII, the micro and degree sign, the superscripts 2 and 3, times, middle dot, plus-minus, minus, umlauts; anything else is a box.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace bolide::observe {

/// A piece of a pen's way, from one point to another.
struct pen_segment {
  double x0, y0, x1, y1;
};

namespace detail {
struct glyph {
  char32_t code;
  int width;
  std::string_view strokes;
};

inline constexpr glyph glyphs[] = {
    {U'0', 6, "o03636C0C"}, {U'1', 3, "-0A3C33"}, {U'2', 6, "~0A0C6C6703 -0363"}, {U'3', 6, "~0A0C6C6828 ~2868630305"},
    {U'4', 6, "-5C0565 -5C53"}, {U'5', 6, "-5C0C08 ~080969630305"}, {U'6', 6, "o03636909 ~5C0C06"}, {U'7', 6, "-0C6C23"},
    {U'8', 6, "o18585C1C o03636808"}, {U'9', 6, "o06666C0C ~696313"},
    {U'A', 8, "-034C83 -1676"}, {U'B', 6, "-030C -0C3C ~3C5C5838 -3808 ~38686333 -3303"}, {U'C', 6, "~6A6C0C036365"},
    {U'D', 6, "-23030C2C ~2C6C6323"}, {U'E', 5, "-53030C5C -0848"}, {U'F', 5, "-030C5C -0848"}, {U'G', 6, "~6A6C0C036367 -6747"},
    {U'H', 6, "-030C -636C -0868"}, {U'I', 0, "-030C"}, {U'J', 4, "-4C46 ~46430305"}, {U'K', 6, "-030C -6C06 -2863"},
    {U'L', 5, "-0C0353"}, {U'M', 8, "-030C468C83"}, {U'N', 6, "-030C636C"}, {U'O', 7, "o03737C0C"}, {U'P', 6, "-030C3C ~3C6C6737 -3707"},
    {U'Q', 7, "o03737C0C -4673"}, {U'R', 6, "-030C3C ~3C6C6737 -3707 -3763"}, {U'S', 6, "~6A6C0C0867630305"}, {U'T', 6, "-0C6C -3C33"},
    {U'U', 6, "-0C06 ~06036366 -666C"}, {U'V', 6, "-0C336C"}, {U'W', 8, "-0C2349638C"}, {U'X', 6, "-036C -0C63"},
    {U'Y', 6, "-0C376C -3733"}, {U'Z', 6, "-0C6C0363"},
    {U'a', 5, "o03535909 -5953"}, {U'b', 5, "-0C03 o03535909"}, {U'c', 5, "~585909035354"}, {U'd', 5, "-5C53 o03535909"},
    {U'e', 5, "-0656 ~565909035354"}, {U'f', 3, "~3C1C1A -1A13 -0939"}, {U'g', 5, "o03535909 -5953 ~53500001"},
    {U'h', 5, "-0C03 ~06095956 -5653"}, {U'i', 0, "-0903 .0C"}, {U'j', 2, "-2922 ~222000 .2C"}, {U'k', 4, "-0C03 -4906 -1743"},
    {U'l', 0, "-0C03"}, {U'm', 8, "-0903 ~06094946 -4643 ~46498986 -8683"}, {U'n', 5, "-0903 ~06095956 -5653"}, {U'o', 5, "o03535909"},
    {U'p', 5, "-0900 o03535909"}, {U'q', 5, "-5950 o03535909"}, {U'r', 3, "-0903 ~060939"}, {U's', 4, "~4849090646430304"},
    {U't', 3, "-1C15 ~151333 -0939"}, {U'u', 5, "-0906 ~06035356 -5953"}, {U'v', 4, "-092349"}, {U'w', 8, "-0923486389"},
    {U'x', 4, "-0349 -0943"}, {U'y', 4, "-0923 -4910"}, {U'z', 4, "-09490343"},
    {U' ', 2, ""}, {U'.', 0, ".03"}, {U',', 1, "-1301"}, {U':', 0, ".04 .08"}, {U';', 1, "-1401 .18"}, {U'-', 4, "-0747"},
    {U'+', 6, "-3A34 -0767"}, {U'=', 5, "-0656 -0858"}, {U'(', 2, "~2D0A0522"}, {U')', 2, "~0D2A2502"}, {U'[', 2, "-2D0D0222"},
    {U']', 2, "-0D2D2202"}, {U'{', 2, "~2D1D17 ~171222 -0717"}, {U'}', 2, "~0D1D17 ~171202 -1727"}, {U'/', 4, "-024D"},
    {U'\\', 4, "-0D42"}, {U'|', 0, "-0D01"}, {U'%', 7, "o09393C0C o43737646 -136C"}, {U'*', 4, "-2C28 -0B49 -094B"},
    {U'<', 5, "-590653"}, {U'>', 5, "-095603"}, {U'_', 6, "-0161"}, {U'!', 0, "-0C06 .03"}, {U'?', 5, "~0A0C5C5828 -2826 .23"},
    {U'\'', 0, "-0C0A"}, {U'"', 2, "-0C0A -2C2A"}, {U'#', 6, "-132C -435C -0666 -0969"}, {U'^', 4, "-0A2C4A"}, {U'`', 2, "-0C2A"},
    {U'~', 6, "~0709396669"}, {U'&', 6, "-631A ~1A1C4C4907035367"}, {U'$', 6, "~6A6C0C0867630305 -3D32"}, {U'@', 8, "o02828C0C o25656929"},
    {U'\u00b5', 5, "-0900 ~06035356 -5953"}, {U'\u00d7', 4, "-0549 -0945"}, {U'\u00b2', 3, "~0B0D3D3B08 -0838"},
    {U'\u00b3', 3, "~0C0D3D3B1B ~1B3B380809"}, {U'\u00b7', 0, ".07"}, {U'\u00b0', 3, "o0A3A3D0D"}, {U'\u00b1', 6, "-3B35 -0868 -0363"},
    {U'\u2212', 6, "-0767"}, {U'\u00e4', 5, "o03535909 -5953 .1B .4B"}, {U'\u00f6', 5, "o03535909 .1B .4B"},
    {U'\u00fc', 5, "-0906 ~06035356 -5953 .1B .4B"}, {U'\u00c4', 8, "-034C83 -1676 .2D .6D"}, {U'\u00d6', 7, "o03737C0C .1E .6E"},
    {U'\u00dc', 6, "-0C06 ~06036366 -666C .1E .5E"}, {U'\u00df', 5, "~030C5C5818 ~1858530313"}};
inline constexpr glyph unknown_glyph{0, 5, "-030C5C5303"};

inline const glyph& glyph_of(char32_t code) {
  for (const glyph& g : glyphs)
    if (g.code == code) return g;
  return unknown_glyph;
}

inline double base36(char c) { return c <= '9' ? c - '0' : c - 'A' + 10; }

struct pen_point {
  double x, y;
};

/// The quadratic B-spline of the control points p as straight pieces.
inline void trace_spline(const std::vector<pen_point>& p, bool closed, std::vector<pen_segment>& to) {
  const std::size_t n = p.size();
  const auto middle = [](pen_point a, pen_point b) { return pen_point{(a.x + b.x) / 2, (a.y + b.y) / 2}; };
  for (std::size_t i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
    const pen_point control = p[i];
    const pen_point from = !closed && i == 1 ? p[0] : middle(p[(i + n - 1) % n], control);
    const pen_point end = !closed && i == n - 2 ? p[n - 1] : middle(control, p[(i + 1) % n]);
    constexpr int pieces = 8;
    pen_point last = from;
    for (int k = 1; k <= pieces; ++k) {
      const double t = double(k) / pieces, u = 1 - t;
      const pen_point now{u * u * from.x + 2 * u * t * control.x + t * t * end.x, u * u * from.y + 2 * u * t * control.y + t * t * end.y};
      to.push_back({last.x, last.y, now.x, now.y});
      last = now;
    }
  }
}

/// One stroke, kind first.
inline void trace_stroke(std::string_view stroke, std::vector<pen_segment>& to) {
  std::vector<pen_point> p;
  for (std::size_t i = 1; i + 1 < stroke.size(); i += 2) p.push_back({base36(stroke[i]), base36(stroke[i + 1])});
  if (stroke[0] == '.')
    for (const pen_point q : p) to.push_back({q.x, q.y, q.x, q.y});
  else if (stroke[0] == '-')
    for (std::size_t i = 1; i < p.size(); ++i) to.push_back({p[i - 1].x, p[i - 1].y, p[i].x, p[i].y});
  else trace_spline(p, stroke[0] == 'o', to);
}

/// The next code point of a UTF-8 text; a broken byte is taken as itself.
inline char32_t next_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0);
  const std::size_t length = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  char32_t code = length == 1 ? first : first & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) code = (code << 6) | (byte(i) & 0x3Fu);
  text.remove_prefix(std::min(length, text.size()));
  return code;
}
} // namespace detail

/// Height of capitals, and the distance between two letters, in units of the glyphs' grid.
inline constexpr double capital_height = 9, letter_gap = 2.6;

/// Width of a line of text that is `height` high (capitals), in the unit of height.
inline double text_width(std::string_view text, double height) {
  double width = text.empty() ? 0 : -letter_gap;
  while (!text.empty()) width += detail::glyph_of(detail::next_code_point(text)).width + letter_gap;
  return width * height / capital_height;
}

/// The pen's way for a line of text whose baseline starts at (0, 0); y points up.
inline std::vector<pen_segment> trace_text(std::string_view text, double height) {
  std::vector<pen_segment> way;
  const double scale = height / capital_height;
  double x = 0;
  while (!text.empty()) {
    const detail::glyph& g = detail::glyph_of(detail::next_code_point(text));
    const std::size_t first = way.size();
    for (std::string_view rest = g.strokes; !rest.empty();) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      detail::trace_stroke(rest.substr(0, end), way);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    for (std::size_t i = first; i < way.size(); ++i)
      way[i] = {(way[i].x0 + x) * scale, (way[i].y0 - 3) * scale, (way[i].x1 + x) * scale, (way[i].y1 - 3) * scale};
    x += g.width + letter_gap;
  }
  return way;
}

} // namespace bolide::observe
