// Things with a plug: screens, hi-fi, kitchen machines, fans, computers.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/casework.h"

namespace idap::parametric {

namespace {

void dial(Builder& b, Vec3 at, double radius, double depth) {
  b.within(facing(at, {0, -1, 0}), [&] { b.cone({}, radius, 0.86 * radius, depth, 0.15 * depth, 28); });
}

void panelBehind(Builder& b, const Pane& p, double y0, double y1, double bezel) {
  b.slot("case");
  b.box({p.x0, y0 + 0.0006, p.z0}, {p.x1, y1, p.z1}, 0.003);
  b.slot("screen");
  const Pane in{p.x0 + bezel, p.z0 + 1.8 * bezel, p.x1 - bezel, p.z1 - bezel};
  b.box({in.x0, y0, in.z0}, {in.x1, y0 + 0.002, in.z1}, 0.0003);
}

// A flat screen on a stand, on two feet, or on the wall.
void television(Builder& b, const Parameters& p) {
  const std::string stand = p.text("stand", "feet");
  const double h = b.height(), foot = stand == "wall" ? 0 : std::min(0.075, 0.12 * h);
  const double thin = 0.022, y = stand == "wall" ? b.front() : -0.02;
  panelBehind(b, {b.left(), foot, b.right(), h}, y, y + thin, 0.008);
  b.slot("case");
  // The thicker lower half holds the works.
  const double y1 = stand == "wall" ? b.back() : y + thin + 0.035;
  b.box({0.6 * b.left(), y + thin - 0.002, foot + 0.06 * h}, {0.6 * b.right(), y1, foot + 0.6 * h}, 0.012);
  if (stand != "wall") b.slot("stand");
  if (stand == "feet") {
    b.mirroredX([&] {
      const double x = 0.32 * b.width();
      b.tube(roundedPath({{x - 0.03, b.front() + 0.006, 0.006}, {x, 0, foot + 0.01}}, 0.01), 0.006, 10);
      b.tube(roundedPath({{x + 0.03, b.back() - 0.006, 0.006}, {x, 0, foot + 0.01}}, 0.01), 0.006, 10);
    });
  } else if (stand == "pedestal") {
    const double w = 0.22 * b.width();
    b.extrude(roundedRectangle({-w, b.front()}, {w, b.back()}, 0.04), 0, 0.012, 0.003);
    b.box({-0.03, y + thin - 0.002, 0.01}, {0.03, y + thin + 0.016, foot + 0.2 * h}, 0.004);
  }
}

void monitor(Builder& b, const Parameters&) {
  const double h = b.height(), screen = 0.66 * h, y = b.front() + 0.35 * b.depth();
  b.slot("stand");
  b.extrude(roundedRectangle({-0.21 * b.width(), b.front()}, {0.21 * b.width(), b.back()}, 0.02), 0, 0.01,
            0.003);
  b.box({-0.03, y + 0.04, 0.008}, {0.03, y + 0.058, 0.7 * h}, 0.005);
  b.rod({0, y + 0.045, 0.66 * h}, {0, y + 0.015, 0.66 * h}, 0.02);
  panelBehind(b, {b.left(), h - screen, b.right(), h}, y, y + 0.02, 0.008);
}

void laptop(Builder& b, const Parameters& p) {
  const double t = 0.014, open = p.number("open", 110) * kPi / 180;
  const double deep = b.depth() - std::max(0.0, -std::cos(open)) * (b.height() / std::sin(open));
  const double y0 = b.front(), y1 = b.front() + deep;
  b.slot("case");
  b.extrude(roundedRectangle({b.left(), y0}, {b.right(), y1}, 0.012), 0, t, 0.003);
  b.slot("keys");
  const int columns = 14, rows = 5;
  const double kx0 = 0.88 * b.left(), kw = 0.88 * b.width() / columns, ky1 = y1 - 0.12 * deep,
               kd = 0.4 * deep / rows;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      if (r == rows - 1 && c > 4 && c < 9) {
        if (c == 5)
          b.box({kx0 + kw * 5 + 0.001, ky1 - kd * 5 + 0.001, t - 0.001},
                {kx0 + kw * 9 - 0.001, ky1 - kd * 4 - 0.001, t + 0.001}, 0.0005);
        continue;
      }
      b.box({kx0 + kw * c + 0.001, ky1 - kd * (r + 1) + 0.001, t - 0.001},
            {kx0 + kw * (c + 1) - 0.001, ky1 - kd * r - 0.001, t + 0.001}, 0.0005);
    }
  }
  b.slot("pad");
  b.box({-0.17 * b.width(), y0 + 0.05 * deep, t - 0.001}, {0.17 * b.width(), y0 + 0.38 * deep, t + 0.0003},
        0);
  const double lid = (b.height() - t) / std::sin(open);
  b.within(Transform::translation({0, y1 - 0.006, t}) * Transform::rotationX(-open), [&] {
    // The lid lies forward when shut: along -y, its screen below. Turned by `open` it stands.
    b.slot("case");
    b.box({b.left(), -lid, 0}, {b.right(), 0, 0.006}, 0.002);
    b.slot("screen");
    b.box({b.left() + 0.006, -lid + 0.006, -0.0006}, {b.right() - 0.006, -0.012, 0.001}, 0);
  });
}

// Turntable, amplifier and a pair of speakers in a row; or one of them.
void speaker(Builder& b, double x0, double x1, double y0, double z0, double z1, double back) {
  b.slot("wood");
  b.box({x0, y0 + 0.008, z0}, {x1, back, z1}, 0.004, Grain::Z);
  b.slot("front");
  b.box({x0 + 0.006, y0 + 0.003, z0 + 0.006}, {x1 - 0.006, y0 + 0.01, z1 - 0.006}, 0.002);
  const double w = x1 - x0, h = z1 - z0, x = (x0 + x1) / 2;
  const auto cone = [&](double z, double r) {
    b.within(facing({x, y0 + 0.003, z}, {0, -1, 0}), [&] {
      b.slot("metal");
      b.torus({0, 0, 0}, r, 0.003, 32, 8);
      b.slot("cone");
      b.lathe({0, 0, 0}, {{0.3 * r, -0.001},
                          {0.86 * r, 0.0004},
                          {r, 0.001},
                          {r, 0.0015},
                          {0.82 * r, 0.0035},
                          {0.45 * r, 0.0006},
                          {0.28 * r, 0.002},
                          {0, 0.003}});
    });
  };
  const int woofers = h > 0.7 ? 2 : 1;
  for (int i = 0; i < woofers; ++i)
    cone(z0 + (h > 0.7 ? 0.42 + 0.24 * i : 0.36) * h, 0.38 * std::min(w, 0.5 * h));
  cone(z0 + 0.82 * h, 0.16 * std::min(w, 0.5 * h));
}

void hifi(Builder& b, const Parameters& p) {
  const double speakerWidth = std::min(0.22, 0.22 * b.width()), y0 = b.front(), h = b.height();
  speaker(b, b.left(), b.left() + speakerWidth, y0, 0, h, b.back());
  speaker(b, b.right() - speakerWidth, b.right(), y0, 0, h, b.back());
  const double x0 = b.left() + speakerWidth + 0.03, x1 = b.right() - speakerWidth - 0.03,
               amp = std::min(0.12, 0.4 * h);
  const double front = y0 + 0.02;
  b.slot("metal");
  b.box({x0, front, 0.012}, {x1, b.back() - 0.02, amp}, 0.003, Grain::X);
  b.slot("cone");
  for (const double f : {0.08, 0.92})
    b.box({x0 + f * (x1 - x0) - 0.015, front + 0.02, 0}, {x0 + f * (x1 - x0) + 0.015, b.back() - 0.04, 0.013},
          0.002);
  b.slot("screen");
  b.box({x0 + 0.3 * (x1 - x0), front - 0.001, 0.35 * amp}, {x0 + 0.62 * (x1 - x0), front + 0.002, 0.75 * amp},
        0.0005);
  b.slot("knob");
  dial(b, {x0 + 0.82 * (x1 - x0), front, 0.55 * amp}, 0.28 * amp, 0.018);
  for (const double f : {0.09, 0.16, 0.23})
    dial(b, {x0 + f * (x1 - x0), front, 0.55 * amp}, 0.1 * amp, 0.012);
  if (!p.flag("turntable", true)) return;
  b.slot("wood");
  const double z = amp + 0.012;
  b.box({x0 + 0.005, front + 0.005, z}, {x1 - 0.005, b.back() - 0.01, z + 0.05}, 0.004, Grain::X);
  b.slot("cone");
  const double r = std::min(0.15, 0.42 * (b.back() - front)), px = x0 + 0.02 + r + 0.02,
               py = (front + b.back()) / 2;
  for (const double sx : {x0 + 0.04, x1 - 0.04})
    for (const double sy : {front + 0.04, b.back() - 0.05})
      b.cylinder({sx, sy, amp - 0.001}, 0.016, 0.014, 0.001);
  b.lathe({px, py, z + 0.05},
          {{0, 0}, {r, 0}, {r, 0.012}, {r - 0.002, 0.014}, {0.35 * r, 0.0145}, {0.34 * r, 0.013}, {0, 0.013}},
          48);
  b.slot("knob");
  b.cylinder({px, py, z + 0.062}, 0.004, 0.012, 0.001, 12);
  b.cylinder({x1 - 0.05, b.back() - 0.07, z + 0.05}, 0.02, 0.03, 0.002);
  b.tube(roundedPath({{x1 - 0.05, b.back() - 0.05, z + 0.078},
                      {x1 - 0.05, front + 0.1, z + 0.078},
                      {px + 0.55 * r, py - 0.55 * r, z + 0.07}},
                     0.04),
         0.0035, 10);
}

// A case radio with a round speaker, dial and carrying handle.
void radio(Builder& b, const Parameters&) {
  const double handle = std::min(0.06, 0.22 * b.height()), h = b.height() - handle, knob = 0.014,
               y0 = b.front() + knob;
  b.slot("wood");
  b.roundedBox({b.left(), y0 + 0.004, 0.006}, {b.right(), b.back(), h}, 0.022, 5, Grain::X);
  b.slot("front");
  const double e = 0.016;
  b.extrudeAlongY(roundedRectangle({b.left() + e, 0.006 + e}, {b.right() - e, h - e}, 0.014), y0, y0 + 0.012,
                  0.002);
  b.slot("grille");
  const double gx1 = b.left() + 0.56 * b.width();
  const int slats = fitting(h - 2 * e - 0.03, 0.009, 40);
  for (int i = 0; i < slats; ++i) {
    const double z = 0.006 + e + 0.015 + (h - 2 * e - 0.036) * (i + 0.5) / slats;
    b.box({b.left() + e + 0.014, y0 - 0.003, z - 0.0026}, {gx1, y0 + 0.002, z + 0.0026}, 0.001);
  }
  b.slot("dial");
  b.box({gx1 + 0.02, y0 - 0.002, 0.55 * h}, {b.right() - e - 0.014, y0 + 0.002, h - e - 0.016}, 0.001);
  b.slot("metal");
  const double mx = (gx1 + 0.02 + b.right() - e - 0.014) / 2, w = b.right() - e - 0.034 - gx1;
  for (const double f : {-0.28, 0.28}) dial(b, {mx + f * w, y0, 0.3 * h}, 0.16 * std::min(w, h), knob);
  b.slot("handle");
  b.tube(roundedPath({{b.left() + 0.05, 0.01, h - 0.02},
                      {b.left() + 0.05, 0.01, b.height() - 0.006},
                      {b.right() - 0.05, 0.01, b.height() - 0.006},
                      {b.right() - 0.05, 0.01, h - 0.02}},
                     0.025),
         0.006, 10);
  b.slot("grille");
  b.mirroredXY([&] { b.cylinder({b.right() - 0.03, b.back() - 0.03, 0}, 0.01, 0.01, 0.001, 16); });
}

void fridge(Builder& b, const Parameters& p) {
  const bool sideBySide = p.flag("sideBySide"), retro = p.flag("retro");
  const double stand = 0.035, out = 0.045, y0 = b.front() + out, doorDepth = 0.07, inner = y0 + doorDepth;
  b.slot("case");
  b.box({b.left(), inner + 0.006, 0.012}, {b.right(), b.back(), b.height()}, retro ? 0.03 : 0.004, Grain::Z);
  b.slot("seal");
  b.box({b.left() + 0.008, inner - 0.002, stand + 0.01},
        {b.right() - 0.008, inner + 0.008, b.height() - 0.012}, 0);
  b.box({b.left() + 0.01, y0 + 0.03, 0}, {b.right() - 0.01, b.back() - 0.05, stand}, 0.002);
  const auto leaf = [&](const Pane& q, double handleX, double z0, double z1) {
    b.slot("door");
    if (retro)
      b.roundedBox({q.x0, y0, q.z0}, {q.x1, inner, q.z1}, 0.034, 6, Grain::Z);
    else
      b.box({q.x0, y0, q.z0}, {q.x1, inner, q.z1}, 0.006, Grain::Z);
    b.slot("handle");
    b.barPull({handleX, y0, (z0 + z1) / 2}, z1 - z0, true, 0.009, out - 0.009);
  };
  const double h = b.height();
  if (sideBySide) {
    const double split = -0.08 * b.width();
    leaf({b.left(), stand, split - 0.002, h}, split - 0.045, 0.45 * h, 0.8 * h);
    leaf({split + 0.002, stand, b.right(), h}, split + 0.045, 0.45 * h, 0.8 * h);
    b.slot("screen");
    b.box({(b.left() + split) / 2 - 0.08, y0 - 0.002, 0.52 * h},
          {(b.left() + split) / 2 + 0.08, y0 + 0.002, 0.72 * h}, 0.001);
  } else {
    const double split = p.flag("freezerOnTop", retro) ? 0.72 * h : 0.36 * h;
    const double x = b.right() - 0.05, reach = std::min(0.36, 0.25 * h);
    leaf({b.left(), stand, b.right(), split - 0.003}, x,
         split - 0.05 - std::min(reach, 0.7 * (split - stand)), split - 0.05);
    leaf({b.left(), split + 0.003, b.right(), h}, x, split + 0.06,
         split + 0.06 + std::min(reach, 0.7 * (h - split)));
  }
}

void washer(Builder& b, const Parameters& p) {
  const bool dish = p.text("style", "washer") == "dishwasher";
  const double out = 0.04, y0 = b.front() + out, h = b.height(), panel = 0.13;
  b.slot("case");
  b.box({b.left(), y0 + 0.02, 0.02}, {b.right(), b.back(), h - 0.022}, 0.004, Grain::Z);
  b.box({b.left(), y0 + 0.004, h - 0.024}, {b.right(), b.back(), h}, 0.005, Grain::X);
  b.box({b.left() + 0.001, y0, h - 0.026 - panel}, {b.right() - 0.001, y0 + 0.024, h - 0.026}, 0.004,
        Grain::X);
  b.slot("seal");
  b.box({b.left() + 0.01, y0 + 0.03, 0}, {b.right() - 0.01, b.back() - 0.04, 0.1}, 0.002);
  b.slot("screen");
  b.box({0.02, y0 - 0.001, h - 0.1}, {0.14, y0 + 0.002, h - 0.06}, 0.001);
  if (dish) {
    b.slot("case");
    b.box({b.left() + 0.001, y0 + 0.002, 0.1}, {b.right() - 0.001, y0 + 0.024, h - 0.03 - panel}, 0.004,
          Grain::X);
    b.slot("chrome");
    b.barPull({0, y0 + 0.002, h - 0.075 - panel}, 0.8 * b.width(), false, 0.009, out + 0.002 - 0.009);
    return;
  }
  b.box({b.left() + 0.03, y0 - 0.002, h - 0.125}, {b.left() + 0.17, y0 + 0.002, h - 0.05}, 0.003);
  b.slot("chrome");
  dial(b, {-0.04, y0, h - 0.026 - panel / 2}, 0.032, 0.024);
  b.slot("case");
  b.box({b.left() + 0.001, y0 + 0.001, 0.1}, {b.right() - 0.001, y0 + 0.022, h - 0.028 - panel}, 0.004,
        Grain::X);
  const double r = std::min(0.2, 0.36 * b.width()), z = 0.1 + 0.52 * (h - panel - 0.13);
  b.within(facing({0, y0 + 0.001, z}, {0, -1, 0}), [&] {
    b.slot("chrome");
    b.lathe({},
            fillet({{0.7 * r, 0},
                    {r, 0},
                    {0.97 * r, out - 0.004},
                    {0.9 * r, out},
                    {0.74 * r, 0.6 * out},
                    {0.7 * r, 0.3 * out}},
                   0.006, 4),
            56);
    b.slot("dark-glass");
    b.lathe({},
            spline2({{0.73 * r, 0.008},
                     {0.72 * r, 0.55 * out},
                     {0.55 * r, 0.8 * out},
                     {0.3 * r, 0.9 * out},
                     {0, 0.92 * out}},
                    4),
            56);
    b.slot("case");
    b.box({0.86 * r, -0.05, 0.6 * out}, {1.06 * r, 0.05, 0.9 * out}, 0.006);
  });
}

void stove(Builder& b, const Parameters& p) {
  const double out = 0.045, y0 = b.front() + out, h = b.height() - 0.03;
  const bool gas = p.flag("gas", true);
  b.slot("case");
  b.box({b.left(), y0 + 0.02, 0.03}, {b.right(), b.back(), h - 0.03}, 0.004, Grain::Z);
  b.slot("seal");
  b.box({b.left() + 0.01, y0 + 0.06, 0}, {b.right() - 0.01, b.back() - 0.05, 0.1}, 0.002);
  b.slot("hob");
  b.box({b.left(), y0, h - 0.032}, {b.right(), b.back(), h}, 0.006);
  b.slot("case");
  const double drawerTop = 0.27, ovenTop = h - 0.15;
  b.box({b.left() + 0.001, y0, 0.1}, {b.right() - 0.001, y0 + 0.024, drawerTop}, 0.004, Grain::X);
  b.box({b.left() + 0.001, y0, drawerTop + 0.004}, {b.right() - 0.001, y0 + 0.024, ovenTop}, 0.005, Grain::X);
  b.box({b.left() + 0.001, y0 + 0.002, ovenTop + 0.004}, {b.right() - 0.001, y0 + 0.026, h - 0.034}, 0.004,
        Grain::X);
  b.slot("dark-glass");
  b.box({b.left() + 0.07, y0 - 0.002, drawerTop + 0.07}, {b.right() - 0.07, y0 + 0.002, ovenTop - 0.11},
        0.001);
  b.slot("chrome");
  b.barPull({0, y0, ovenTop - 0.045}, 0.84 * b.width(), false, 0.01, out - 0.01);
  b.barPull({0, y0, drawerTop - 0.045}, 0.5 * b.width(), false, 0.007, 0.03);
  b.slot("knob");
  for (int i = 0; i < 5; ++i)
    dial(b, {(i - 2) * 0.17 * b.width(), y0 + 0.002, (ovenTop + h - 0.03) / 2}, 0.021, 0.026);
  const double cy = (y0 + b.back()) / 2 + 0.01;
  for (const double fx : {-0.25, 0.25}) {
    for (const double fy : {-0.22, 0.22}) {
      b.at({fx * b.width(), cy + fy * (b.back() - y0), h}, [&] {
        b.slot("grate");
        if (!gas) {
          b.cylinder({0, 0, -0.001}, 0.095, 0.014, 0.003, 40);
          b.cylinder({0, 0, 0.012}, 0.03, 0.018, 0.003, 24);
          return;
        }
        b.cylinder({0, 0, -0.001}, 0.045, 0.012, 0.002);
        b.cylinder({0, 0, 0.01}, 0.032, 0.006, 0.002);
        for (int i = 0; i < 4; ++i)
          b.within(Transform::rotationZ(kPi / 2 * i), [&] {
            b.box({0.025, -0.005, 0.02}, {0.22 * b.width(), 0.005, 0.03}, 0.002);
            b.box({0.22 * b.width() - 0.01, -0.005, -0.001}, {0.22 * b.width(), 0.005, 0.03}, 0.002);
          });
      });
    }
  }
}

void microwave(Builder& b, const Parameters&) {
  const double out = 0.03, y0 = b.front() + out, h = b.height(), split = b.right() - 0.24 * b.width();
  b.slot("case");
  b.box({b.left(), y0 + 0.02, 0.01}, {b.right(), b.back(), h}, 0.005, Grain::X);
  b.box({b.left(), y0, 0.012}, {split - 0.001, y0 + 0.024, h - 0.002}, 0.004, Grain::X);
  b.box({split + 0.001, y0, 0.012}, {b.right(), y0 + 0.024, h - 0.002}, 0.004, Grain::X);
  b.slot("dark-glass");
  b.box({b.left() + 0.035, y0 - 0.0015, 0.05}, {split - 0.05, y0 + 0.002, h - 0.04}, 0.001);
  b.box({split + 0.02, y0 - 0.0015, h - 0.075}, {b.right() - 0.02, y0 + 0.002, h - 0.035}, 0.001);
  b.slot("chrome");
  b.barPull({split - 0.025, y0, h / 2}, 0.7 * h, true, 0.006, out - 0.006);
  dial(b, {(split + b.right()) / 2, y0, 0.3 * h}, 0.16 * h, 0.02);
  b.slot("keys");
  for (int i = 0; i < 6; ++i)
    b.box({split + 0.022 + (i % 3) * 0.22 * (b.right() - split), y0 - 0.002, 0.56 * h - (i / 3) * 0.022},
          {split + 0.022 + (i % 3) * 0.22 * (b.right() - split) + 0.16 * (b.right() - split), y0 + 0.001,
           0.56 * h - (i / 3) * 0.022 + 0.014},
          0.001);
  b.slot("seal");
  b.mirroredXY([&] { b.cylinder({b.right() - 0.04, b.back() - 0.06, 0}, 0.014, 0.012, 0.001, 16); });
}

// Split unit on the wall: a soft-edged case with a louvre below.
void airConditioner(Builder& b, const Parameters&) {
  const double y0 = b.front() + 0.011, y1 = b.back(), h = b.height();
  b.slot("case");
  const std::vector<Vec2> section{{y1, 0.02},
                                  {y1, h},
                                  {y0 + 0.25 * (y1 - y0), h},
                                  {y0, 0.86 * h},
                                  {y0, 0.3 * h},
                                  {y0 + 0.35 * (y1 - y0), 0},
                                  {y1 - 0.2 * (y1 - y0), 0}};
  b.extrudeAlongX(fillet(section, 0.03, 6), b.left(), b.right(), 0.006);
  b.slot("louvre");
  b.within(Transform::translation({0, y0 + 0.11 * (y1 - y0), 0.17 * h}) * Transform::rotationX(-0.75), [&] {
    b.box({0.9 * b.left(), -0.045, -0.003}, {0.9 * b.right(), 0.045, 0.003}, 0.0025, Grain::X);
  });
  b.slot("screen");
  b.box({b.right() - 0.16, y0 - 0.0001, 0.5 * h}, {b.right() - 0.07, y0 + 0.002, 0.58 * h}, 0.0005);
}

void fan(Builder& b, const Parameters& p) {
  const double head = b.width() / 2, h = b.height(), z = h - head;
  const double foot = b.depth() / 2;
  b.slot("case");
  b.lathe(
      {},
      fillet({{0, 0}, {foot, 0}, {foot, 0.012}, {0.25 * foot, 0.035}, {0.018, 0.05}, {0, 0.05}}, 0.008, 4),
      48);
  b.slot("metal");
  b.rod({0, 0.02, 0.03}, {0, 0.02, z - 0.05}, 0.014, 18);
  b.slot("case");
  const double y = -0.02;
  b.within(facing({0, 0.09, z}, {0, -1, 0}), [&] {
    b.lathe({}, spline2({{0, 0}, {0.04, 0.006}, {0.055, 0.04}, {0.05, 0.085}, {0.02, 0.1}, {0, 0.1}}, 4), 28);
  });
  b.box({-0.022, 0.0, z - 0.09}, {0.022, 0.045, z - 0.02}, 0.008);
  b.within(facing({0, y, z}, {0, -1, 0}), [&] {
    b.slot("blade");
    const int blades = std::clamp(p.count("blades", 3), 2, 7);
    for (int i = 0; i < blades; ++i)
      b.within(Transform::rotationZ(2 * kPi * i / blades), [&] {
        b.surface(
            [&](double u, double v) {
              const double r = head * (0.14 + 0.74 * u),
                           wide = head * (0.12 + 0.34 * std::sqrt(u) * (1.15 - 0.5 * u * u));
              const double s = v - 0.5, twist = 0.55 - 0.25 * u;
              return Vec3{r, s * 2 * wide * std::cos(twist), s * 2 * wide * 0.34 * std::sin(twist)};
            },
            10, 6, 0.002);
      });
    b.lathe({0, 0, -0.02}, spline2({{0, 0}, {0.16 * head, 0.002}, {0.15 * head, 0.03}, {0, 0.042}}, 4), 24);
    b.slot("metal");  // the cage
    const double deep = 0.045;
    b.torus({}, head - 0.005, 0.005, 64, 8);
    for (const double side : {-1.0, 1.0}) {
      const int wires = 36;
      for (int i = 0; i < wires; ++i) {
        const double a = 2 * kPi * i / wires, c = std::cos(a), s = std::sin(a);
        b.tube({{0.2 * head * c, 0.2 * head * s, side * deep},
                {0.7 * head * c, 0.7 * head * s, side * deep * 0.9},
                {(head - 0.005) * c, (head - 0.005) * s, 0}},
               0.0014, 5, Cap::None);
      }
      b.torus({0, 0, side * deep}, 0.2 * head, 0.003, 32, 6);
      b.torus({0, 0, side * deep * 0.9}, 0.7 * head, 0.0014, 48, 5);
    }
    b.slot("case");
    b.cylinder({0, 0, deep - 0.004}, 0.2 * head, 0.008, 0.002, 32);
  });
}

}  // namespace

void addAppliances(Generators& to) {
  to["television"] = television;
  to["monitor"] = monitor;
  to["laptop"] = laptop;
  to["hifi"] = hifi;
  to["radio"] = radio;
  to["fridge"] = fridge;
  to["washingMachine"] = washer;
  to["stove"] = stove;
  to["microwave"] = microwave;
  to["airConditioner"] = airConditioner;
  to["standFan"] = fan;
}

}  // namespace idap::parametric
