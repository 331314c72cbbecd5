#include "geometry/svg_path.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "base/error.h"

namespace idap {

namespace {

constexpr std::size_t kMaxPoints = 100'000;

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

class Reader {
 public:
  Reader(std::string_view path, double tolerance) : path_(path), tolerance_(std::max(tolerance, 1e-9)) {}

  std::vector<Polygon> read() {
    while (skipSeparators(), at_ < path_.size()) {
      const char c = path_[at_];
      if (std::isalpha(static_cast<unsigned char>(c))) {
        ++at_;
        command(c);
      } else {
        fail("a command letter was expected");
      }
    }
    close();
    return std::move(rings_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw ParseError("path", "character " + std::to_string(at_ + 1), reason);
  }

  void skipSeparators() {
    while (at_ < path_.size() && (isSpace(path_[at_]) || path_[at_] == ',')) ++at_;
  }
  bool numberFollows() {
    skipSeparators();
    if (at_ >= path_.size()) return false;
    const char c = path_[at_];
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
  }
  double number() {
    if (!numberFollows()) fail("a number was expected");
    const char* first = path_.data() + at_;
    if (*first == '+') ++first;
    double value = 0;
    const auto [end, error] = std::from_chars(first, path_.data() + path_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) fail("not a number");
    at_ = static_cast<std::size_t>(end - path_.data());
    return value;
  }
  // The flags of an arc may stand without separators: "a1 1 0 01.5.5".
  bool flag() {
    skipSeparators();
    if (at_ >= path_.size() || (path_[at_] != '0' && path_[at_] != '1')) fail("an arc flag must be 0 or 1");
    return path_[at_++] == '1';
  }
  Vec2 point(Vec2 base) {
    const double x = number();
    return base + Vec2{x, number()};
  }

  void command(char letter) {
    const bool relative = letter >= 'a';
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    if (kind == 'Z') {
      close();
      lastKind_ = kind;
      return;
    }
    if (kind != 'M' && !started_) fail("a path begins with M");
    bool first = true;
    do {
      segment(first || kind != 'M' ? kind : 'L', relative);
      lastKind_ = kind;
      first = false;
    } while (numberFollows());
  }

  void segment(char kind, bool relative) {
    const Vec2 base = relative ? pen_ : Vec2{};
    switch (kind) {
      case 'M': {
        const Vec2 p = point(base);
        close();
        pen_ = start_ = p;
        started_ = true;
        break;
      }
      case 'L':
        lineTo(point(base));
        break;
      case 'H':
        lineTo({number() + base.x, pen_.y});
        break;
      case 'V':
        lineTo({pen_.x, number() + base.y});
        break;
      case 'C': {
        const Vec2 a = point(base), b = point(base);
        cubicTo(a, b, point(base));
        break;
      }
      case 'S': {
        const Vec2 a = lastKind_ == 'C' || lastKind_ == 'S' ? pen_ * 2 - control_ : pen_;
        const Vec2 b = point(base);
        cubicTo(a, b, point(base));
        break;
      }
      case 'Q': {
        const Vec2 a = point(base);
        quadraticTo(a, point(base));
        break;
      }
      case 'T': {
        const Vec2 a = lastKind_ == 'Q' || lastKind_ == 'T' ? pen_ * 2 - control_ : pen_;
        quadraticTo(a, point(base));
        break;
      }
      case 'A': {
        const double rx = number(), ry = number(), rotation = number() * kPi / 180;
        const bool large = flag(), sweep = flag();
        arcTo(std::abs(rx), std::abs(ry), rotation, large, sweep, point(base));
        break;
      }
      default:
        fail(std::string("unknown command ") + kind);
    }
  }

  void lineTo(Vec2 p) {
    if (ring_.empty()) ring_.push_back(pen_);
    if (++points_ > kMaxPoints) fail("too many points");
    ring_.push_back(p);
    pen_ = p;
  }

  // Number of chords by Wang's bound: the error of a uniform subdivision of a degree d curve is at most
  // d (d - 1) / 8 times its largest second difference over the square of their number.
  int chords(double secondDifference, int degree) const {
    const double n = std::sqrt(degree * (degree - 1) / 8.0 * secondDifference / tolerance_);
    return static_cast<int>(std::clamp(std::ceil(n), 1.0, 10'000.0));
  }
  void cubicTo(Vec2 a, Vec2 b, Vec2 end) {
    const Vec2 begin = pen_;
    const int n = chords(std::max(length(begin - 2 * a + b), length(a - 2 * b + end)), 3);
    for (int i = 1; i <= n; ++i) {
      const double t = double(i) / n, u = 1 - t;
      lineTo(i == n ? end
                    : begin * (u * u * u) + a * (3 * u * u * t) + b * (3 * u * t * t) + end * (t * t * t));
    }
    control_ = b;
  }
  void quadraticTo(Vec2 a, Vec2 end) {
    const Vec2 begin = pen_;
    const int n = chords(length(begin - 2 * a + end), 2);
    for (int i = 1; i <= n; ++i) {
      const double t = double(i) / n, u = 1 - t;
      lineTo(i == n ? end : begin * (u * u) + a * (2 * u * t) + end * (t * t));
    }
    control_ = a;
  }

  // From end points to centre: SVG 1.1, appendix F.6.
  void arcTo(double rx, double ry, double rotation, bool large, bool sweep, Vec2 end) {
    const Vec2 begin = pen_;
    if (rx == 0 || ry == 0 || begin == end) {
      lineTo(end);
      return;
    }
    const Vec2 half = rotated((begin - end) / 2, -rotation);
    const double lambda = half.x * half.x / (rx * rx) + half.y * half.y / (ry * ry);
    if (lambda > 1) rx *= std::sqrt(lambda), ry *= std::sqrt(lambda);
    const double a = rx * rx * half.y * half.y + ry * ry * half.x * half.x;
    const double factor = (large == sweep ? -1 : 1) * std::sqrt(std::max(0.0, rx * rx * ry * ry / a - 1));
    const Vec2 centred{factor * rx * half.y / ry, -factor * ry * half.x / rx};
    const Vec2 centre = rotated(centred, rotation) + (begin + end) / 2;
    const auto angleOf = [&](Vec2 p) { return std::atan2(p.y / ry, p.x / rx); };
    const double from = angleOf(half - centred);
    double sweepAngle = angleOf(-half - centred) - from;
    if (sweep && sweepAngle < 0) sweepAngle += 2 * kPi;
    if (!sweep && sweepAngle > 0) sweepAngle -= 2 * kPi;
    const double radius = std::max(rx, ry);
    const double step = 2 * std::acos(std::max(0.0, 1 - tolerance_ / radius));
    const int n = static_cast<int>(std::clamp(std::ceil(std::abs(sweepAngle) / step), 1.0, 10'000.0));
    for (int i = 1; i <= n; ++i) {
      const double angle = from + sweepAngle * i / n;
      lineTo(i == n ? end : centre + rotated(Vec2{rx * std::cos(angle), ry * std::sin(angle)}, rotation));
    }
  }

  void close() {
    if (!ring_.empty() && ring_.front() == ring_.back()) ring_.pop_back();
    if (ring_.size() >= 3) rings_.push_back(std::move(ring_));
    ring_.clear();
    pen_ = start_;
  }

  std::string_view path_;
  double tolerance_;
  std::size_t at_ = 0, points_ = 0;
  std::vector<Polygon> rings_;
  Polygon ring_;
  Vec2 pen_, start_, control_;
  char lastKind_ = 0;
  bool started_ = false;
};

}  // namespace

std::vector<Polygon> parseSvgPath(std::string_view path, double tolerance) {
  return Reader(path, tolerance).read();
}

}  // namespace idap
