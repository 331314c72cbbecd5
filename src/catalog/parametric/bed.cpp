// Beds with their bedding.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/registry.h"

namespace idap::parametric {
namespace {

// Mattress, duvet and pillows on a base: the box's floor is the base, its top the mattress's top. The head is
// at the back.
void bedding(Builder& b, Vec3 min, Vec3 max, const Parameters& p) {
  const double w = max.x - min.x, l = max.y - min.y;
  b.slot("mattress");
  b.cushion(min, max, {.radius = 0.05, .crown = 0.006, .segments = 10});
  for (const double t : {0.16, 0.84}) b.piping(min, max, 0.05, 2, t, 0.005);
  const bool doubleBed = w > 1.25;
  const double plump = 0.15, pl = std::min(0.48, 0.26 * l);
  const int pillows = doubleBed ? 2 : 1;
  const double pw = std::min(0.72, (w - 0.06) / pillows);
  b.slot("bedding");
  for (int i = 0; i < pillows; ++i) {
    const double x = (min.x + max.x) / 2 + (i - 0.5 * (pillows - 1)) * (w / pillows);
    // Propped a little against the head.
    b.within(Transform::translation({x, max.y - pl - 0.02, max.z - 0.012}) *
                 Transform::rotationZ(0.03 * (i ? -1 : 1)) * Transform::rotationX(0.16),
             [&] {
               b.cushion(
                   {-pw / 2, 0, 0}, {pw / 2, pl, plump},
                   {.radius = 0.06, .wrinkle = 0.008, .wrinkleLength = 0.3, .pinched = true, .segments = 16});
             });
    if (p.flag("cushions", doubleBed)) {
      b.slot("accent");
      const double s = 0.4;
      b.within(
          Transform::translation({x, max.y - pl - 0.15, max.z + 0.005}) * Transform::rotationX(-0.62), [&] {
            b.cushion(
                {-s / 2, -0.06, 0}, {s / 2, 0.06, s},
                {.radius = 0.05, .wrinkle = 0.005, .wrinkleLength = 0.22, .pinched = true, .segments = 14});
          });
      b.slot("bedding");
    }
  }
  b.slot("duvet");
  const double hang = std::min(p.number("hang", 0.2), max.z - min.z + 0.08);
  b.drape({min.x, min.y, max.z - 0.02}, {max.x, max.y - pl - 0.1, max.z + 0.006},
          {.left = hang,
           .right = hang,
           .front = hang * 0.7,
           .back = 0,
           .thickness = 0.035,
           .radius = 0.05,
           .fold = 0.01,
           .foldLength = 0.33,
           .crown = 0.012,
           .wrinkle = 0.012,
           .segments = 44});
  // Its head end is turned back.
  b.slot("bedding");
  b.drape({min.x + 0.004, max.y - pl - 0.36, max.z + 0.028},
          {max.x - 0.004, max.y - pl - 0.07, max.z + 0.034},
          {.left = hang * 0.8,
           .right = hang * 0.8,
           .front = 0,
           .back = 0,
           .thickness = 0.022,
           .radius = 0.06,
           .fold = 0.01,
           .foldLength = 0.33,
           .crown = 0.006,
           .wrinkle = 0.006,
           .segments = 36});
  if (p.flag("throw", doubleBed)) {
    b.slot("throw");
    b.drape({min.x - 0.012, min.y + 0.14, max.z + 0.03},
            {max.x + 0.012, min.y + 0.14 + std::min(0.55, 0.3 * l), max.z + 0.048},
            {.left = hang * 1.25,
             .right = hang * 1.25,
             .front = 0,
             .back = 0,
             .thickness = 0.01,
             .radius = 0.07,
             .fold = 0.014,
             .foldLength = 0.2,
             .crown = 0.01,
             .wrinkle = 0.008,
             .segments = 40});
  }
}

// Side rails and a slatted ground between head and foot; returns nothing, fills from floor height z0 to z1.
void rails(Builder& b, double x, double y0, double y1, double z0, double z1) {
  b.mirroredX([&] { b.box({x - 0.028, y0, z0}, {x, y1, z1}, 0.004, Grain::Y); });
  const int slats = fitting(y1 - y0, 0.12, 24);
  for (int i = 0; i < slats; ++i) {
    const double y = y0 + (y1 - y0) * (i + 0.5) / slats;
    b.box({-x + 0.028, y - 0.03, z0 + 0.03}, {x - 0.028, y + 0.03, z0 + 0.045}, 0.001, Grain::X);
  }
}

// Style "slatted": posts and upright slats; "panel": framed panels; "metal": bent tubes.
void framedBed(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height();
  const double top = std::min(p.number("bedHeight", 0.5), h - 0.1), mattress = 0.2, base = top - mattress,
               post = 0.03;
  const double footTop = std::min(p.number("footHeight", 0.45), h);
  const std::string style = p.text("style", "slatted");
  const auto end = [&](double y, double height) {
    const double z0 = base - 0.06;
    if (style == "metal") {
      const double r = 0.016;
      b.tube(roundedPath({{-w + r, y, 0}, {-w + r, y, height - r}, {w - r, y, height - r}, {w - r, y, 0}},
                         0.14, 8),
             r, 14, Cap::Flat);
      b.rod({-w + r, y, z0 + 0.05}, {w - r, y, z0 + 0.05}, 0.011);
      const int bars = fitting(2 * w, 0.13, 24);
      for (int i = 1; i < bars; ++i)
        b.rod({-w + 2 * w * i / bars, y, z0 + 0.05}, {-w + 2 * w * i / bars, y, height - r}, 0.006, 8,
              Cap::None);
      return;
    }
    b.mirroredX([&] {
      b.box({w - 2 * post, y - post, 0}, {w, y + post, height - 0.012}, 0.005, Grain::Z);
      b.box({w - 2 * post - 0.004, y - post - 0.0035, height - 0.016}, {w + 0.0, y + post + 0.0035, height},
            0.004, Grain::Y);
    });
    if (height > base + 0.08) {
      b.box({-w + 2 * post, y - 0.018, height - 0.1}, {w - 2 * post, y + 0.018, height - 0.02}, 0.005);
      b.box({-w + 2 * post, y - 0.016, z0}, {w - 2 * post, y + 0.016, z0 + 0.1}, 0.004);
      if (style == "panel") {
        const int panels = fitting(2 * w, 0.55, 8);
        const double x0 = -w + 2 * post - 0.002, each = 2 * (w - 2 * post + 0.002) / panels;
        for (int i = 0; i < panels; ++i)
          b.framedPanel({x0 + i * each, y - 0.015, z0 + 0.099},
                        {x0 + (i + 1) * each, y + 0.015, height - 0.099},
                        {.stile = 0.05, .setBack = 0.009, .panelThickness = 0.012});
      } else {
        const int slats = fitting(2 * w, 0.1, 40);
        for (int i = 1; i < slats; ++i) {
          const double x = -w + post + 2 * (w - post) * i / slats;
          b.box({x - 0.02, y - 0.009, z0 + 0.095}, {x + 0.02, y + 0.009, height - 0.095}, 0.003, Grain::Z);
        }
      }
    } else {
      b.box({-w + 2 * post, y - 0.018, z0}, {w - 2 * post, y + 0.018, height - 0.03}, 0.005);
    }
  };
  b.slot("frame");
  end(k - post - 0.0035, h);
  end(f + post + 0.0035, footTop);
  rails(b, style == "metal" ? w - 0.01 : w - 0.016, f + 0.03, k - 0.03, base - 0.06, base + 0.05);
  const double in = style == "metal" ? 0.045 : 0.05;
  bedding(b, {-w + in, f + 0.075, base - 0.01}, {w - in, k - 0.075, top - 0.04}, p);
}

// Double bed with an upholstered headboard ("channels": upright rolls, "tufted": buttons, "plain") and base.
void upholsteredBed(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height(), legs = 0.1;
  const double top = std::min(p.number("bedHeight", 0.55), h - 0.1), base = top - 0.25, head = 0.11;
  b.slot("legs");
  b.mirroredX([&] {
    b.leg({w - 0.12, f + 0.12, legs + 0.01}, {w - 0.09, f + 0.09, 0}, 0.024, 0.014);
    b.box({w - 0.12, k - 0.09, 0}, {w - 0.06, k - 0.03, legs + 0.01}, 0.003);
  });
  b.slot("fabric");
  const double side = 0.055;
  b.cushion({-w + 0.01, f, legs}, {w - 0.01, k - head + 0.02, base + 0.06},
            {.radius = 0.03, .crown = 0.004, .segments = 8});
  const std::string style = p.text("style", "tufted");
  if (style == "channels") {
    const int n = fitting(2 * w, 0.2, 24);
    for (int i = 0; i < n; ++i) {
      b.cushion({-w + 2 * w * i / n + 0.0005, k - head, legs + 0.02},
                {-w + 2 * w * (i + 1) / n - 0.0005, k, h}, {.radius = 0.045, .crown = 0.022, .segments = 10});
    }
  } else {
    Soft soft{.radius = 0.045, .crown = 0.012};
    if (style == "tufted")
      soft.tuftColumns = fitting(2 * w, 0.23, 14),
      soft.tuftRows = std::max(3, fitting(h - top + 0.1, 0.17, 8)), soft.tuftDepth = 0.028;
    b.box({-w + 0.02, k - 0.05, legs}, {w - 0.02, k - 0.004, top - 0.1}, 0.01);
    b.cushion({-w, k - head, top - 0.16}, {w, k, h}, soft);
  }
  bedding(b, {-w + side, f + 0.04, base - 0.01}, {w - side, k - head - 0.005, top - 0.04}, p);
}

// Four posts that carry a canopy's frame; curtains at the posts where asked.
void canopyBed(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height(), r = 0.032;
  const double top = std::min(p.number("bedHeight", 0.58), h - 0.3), base = top - 0.22;
  b.slot("frame");
  const bool turned = p.flag("turned", true);
  b.mirroredXY([&] {
    const double x = w - r, y = k - r;
    b.box({x - r, y - r, 0}, {x + r, y + r, base + 0.12}, 0.004, Grain::Z);
    if (turned)
      b.leg({x, y, base + 0.119}, {x, y, h - 0.055}, 0.95 * r, 0.62 * r, LegShape::Turned);
    else
      b.box({x - 0.9 * r, y - 0.9 * r, base + 0.1}, {x + 0.9 * r, y + 0.9 * r, h - 0.05}, 0.004, Grain::Z);
  });
  b.mirroredX([&] { b.box({w - 1.7 * r, f + 0.3 * r, h - 0.06}, {w - 0.3 * r, k - 0.3 * r, h}, 0.004); });
  b.mirroredY([&] {
    b.box({-w + 1.7 * r, k - 1.68 * r, h - 0.058}, {w - 1.7 * r, k - 0.32 * r, h - 0.002}, 0.004);
  });
  const double head = base + std::min(0.65, 0.4 * (h - base));
  b.extrudeAlongY(fillet(spline2({{-w + 2 * r, base - 0.05},
                                  {w - 2 * r, base - 0.05},
                                  {w - 2 * r, head - 0.14},
                                  {0.55 * w, head - 0.06},
                                  {0, head},
                                  {-0.55 * w, head - 0.06},
                                  {-w + 2 * r, head - 0.14}},
                                 1),
                         0.01, 2),
                  k - r - 0.014, k - r + 0.014, 0.004);
  b.box({-w + 2 * r, f + r - 0.014, base - 0.06}, {w - 2 * r, f + r + 0.014, base + 0.08}, 0.004);
  rails(b, w - r + 0.014, f + 2 * r, k - 2 * r, base - 0.06, base + 0.06);
  bedding(b, {-w + 0.06, f + 0.085, base - 0.01}, {w - 0.06, k - 0.085, top - 0.04}, p);
  if (p.flag("curtains", true)) {
    b.slot("curtain");
    b.mirroredXY([&] {
      // Gathered cloth around the post's inner sides.
      const double x = w - r, y = k - r;
      b.surface(
          [&](double u, double v) {
            const double a = kPi * (0.98 + 0.54 * u), tie = std::exp(-std::pow((v - 0.45) / 0.1, 2));
            const double ring = 0.075 + 0.05 * (1 - v) - 0.03 * tie +
                                0.014 * std::sin(2 * kPi * 6 * u + 0.5 * std::sin(5 * v));
            return Vec3{x + ring * std::cos(a) * 1.1, y + ring * std::sin(a) * 1.1, 0.03 + (h - 0.09) * v};
          },
          40, 16, 0.002);
    });
  }
}

// Two beds one over the other, with a ladder and guards.
void bunkBed(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height(), post = 0.07;
  b.slot("frame");
  b.mirroredXY([&] { b.box({w - post, k - post, 0}, {w, k, h}, 0.005, Grain::Z); });
  const double low = 0.22, high = std::max(1.05, h - 0.52);
  for (const double z : {low, high}) {
    b.mirroredX([&] { b.box({w - 0.05, f + post, z}, {w - 0.02, k - post, z + 0.13}, 0.004); });
    b.mirroredY([&] { b.box({-w + post, k - 0.05, z}, {w - post, k - 0.02, z + 0.13}, 0.004); });
    const int slats = fitting(k - f, 0.13, 24);
    for (int i = 0; i < slats; ++i) {
      const double y = f + 0.05 + (k - f - 0.1) * (i + 0.5) / slats;
      b.box({-w + 0.05, y - 0.035, z + 0.03}, {w - 0.05, y + 0.035, z + 0.048}, 0.001, Grain::X);
    }
  }
  // Guards above, head and foot boards below.
  const double ladder = 0.4, y1 = f + post + ladder;
  for (const double z : {h - 0.1, h - 0.24}) {
    b.box({-w + 0.02, f + post, z}, {-w + 0.042, k - post, z + 0.085}, 0.004);
    b.box({w - 0.042, y1, z}, {w - 0.02, k - post, z + 0.085}, 0.004);
    b.mirroredY([&] { b.box({-w + post, k - 0.045, z}, {w - post, k - 0.023, z + 0.085}, 0.004); });
  }
  b.box({w - 0.046, y1, high + 0.1}, {w - 0.016, y1 + 0.05, h - 0.012}, 0.004, Grain::Z);
  for (const double z : {low + 0.25, low + 0.42})
    b.mirroredY([&] { b.box({-w + post, k - 0.045, z}, {w - post, k - 0.023, z + 0.085}, 0.004); });
  // The ladder stands upright at the side, within the frame's thickness.
  const double x0 = w - 0.019;
  b.box({x0 - 0.02, y1 - 0.045, 0}, {x0 + 0.019, y1 - 0.001, h - 0.001}, 0.004, Grain::Z);
  const int rungs = fitting(high, 0.27, 10);
  for (int i = 1; i <= rungs; ++i)
    b.box({x0 - 0.022, f + post - 0.004, high * i / rungs - 0.03},
          {x0 + 0.014, y1 - 0.044, high * i / rungs - 0.002}, 0.005, Grain::Y);
  Parameters plain = p;
  plain.numbers["hang"] = 0.06, plain.numbers["throw"] = 0, plain.numbers["cushions"] = 0;
  for (const double z : {low, high})
    bedding(b, {-w + 0.06, f + 0.06, z + 0.05}, {w - 0.06, k - 0.06, z + 0.19}, plain);
}

// A baby's cot: bars all around.
void cot(Builder& b, const Parameters& p) {
  const double w = b.width() / 2, f = b.front(), k = b.back(), h = b.height(), post = 0.04;
  const double base = std::min(p.number("mattressHeight", 0.3), 0.6 * h);
  b.slot("frame");
  b.mirroredXY([&] {
    b.leg({w - post / 2 - 0.004, k - post / 2 - 0.004, h - 0.02}, {w - post / 2, k - post / 2, 0}, post / 2,
          0.6 * post / 2, LegShape::Square);
  });
  const auto side = [&](Vec3 from, Vec3 to) {
    const Vec3 d = normalized(to - from);
    const Vec3 n{std::abs(d.y) * 0.014, std::abs(d.x) * 0.014, 0};
    const auto rail = [&](double z, double tall) {
      b.box(from - n + Vec3{0, 0, z}, to + n + Vec3{0, 0, z + tall}, 0.007);
    };
    rail(h - 0.045, 0.045);
    rail(base - 0.08, 0.05);
    const int bars = fitting(length(to - from), 0.085, 40);
    for (int i = 1; i < bars; ++i) {
      const Vec3 q = from + (to - from) * (static_cast<double>(i) / bars);
      b.rod(q + Vec3{0, 0, base - 0.04}, q + Vec3{0, 0, h - 0.03}, 0.0075, 10, Cap::None);
    }
  };
  const double x = w - post / 2, y = k - post / 2;
  side({x, -y + 0.01, 0}, {x, y - 0.01, 0});
  side({-x, -y + 0.01, 0}, {-x, y - 0.01, 0});
  side({-x + 0.01, y, 0}, {x - 0.01, y, 0});
  side({-x + 0.01, -y, 0}, {x - 0.01, -y, 0});
  b.box({-x, f + 0.02, base - 0.075}, {x, k - 0.02, base - 0.06}, 0.002);
  b.slot("mattress");
  b.cushion({-x + 0.016, f + 0.036, base - 0.059}, {x - 0.016, k - 0.036, base + 0.045},
            {.radius = 0.03, .crown = 0.006});
  b.slot("duvet");
  b.drape({-x + 0.03, f + 0.05, base + 0.03}, {x - 0.03, 0.1, base + 0.05},
          {.left = 0.03,
           .right = 0.03,
           .front = 0.0,
           .back = 0,
           .thickness = 0.018,
           .radius = 0.02,
           .fold = 0.001,
           .crown = 0.02,
           .wrinkle = 0.008,
           .segments = 24});
  b.slot("bedding");
  b.cushion({-0.6 * x, k - 0.3, base + 0.035}, {0.6 * x, k - 0.06, base + 0.09},
            {.radius = 0.025, .pinched = true, .segments = 12});
}

}  // namespace

void addBeds(Generators& to) {
  to["framedBed"] = framedBed;
  to["upholsteredBed"] = upholsteredBed;
  to["canopyBed"] = canopyBed;
  to["bunkBed"] = bunkBed;
  to["cot"] = cot;
}

}  // namespace idap::parametric
