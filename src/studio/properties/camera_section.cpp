// Points of view: where they stand, where they look, through which lens, at which time.
#include <QCheckBox>
#include <cmath>

#include "studio/properties/sections.h"
#include "studio/properties/time_field.h"

namespace idap {

namespace {

constexpr double kHalfFrame = 18;  // mm: half the width of the 36 mm frame that focal lengths are compared by

Home changeCameras(const Home& home, const Elements& e, const std::function<void(Camera&)>& change) {
  return changeEach(home, &Home::cameras, e.cameras, change);
}

bool isFlat(Lens lens) { return lens == Lens::Pinhole || lens == Lens::Orthographic; }

class CameraSection : public Section {
 public:
  CameraSection(PanelLink& panelLink, QWidget* parent)
      : Section(panelLink, "cameraSection", QT_TRANSLATE_NOOP("idap", "Point of view"), parent) {
    addText(
        {"cameraName", QT_TRANSLATE_NOOP("idap", "Name"), QT_TRANSLATE_NOOP("idap", "Change name"),
         QT_TRANSLATE_NOOP("idap", "How it is called in the list of points of view.")},
        [](const Selected& s) { return s.ofCameras([](const Camera& c) { return c.name; }); },
        [](const Home& home, const Elements& e, const std::string& name) {
          return changeCameras(home, e, [&](Camera& c) { c.name = name; });
        });
    addLength(
        {"cameraHeight", QT_TRANSLATE_NOOP("idap", "Eye height"),
         QT_TRANSLATE_NOOP("idap", "Change eye height"),
         QT_TRANSLATE_NOOP("idap", "Above the floor of the level drawn: 1.6 m standing, 1.2 m sitting.")},
        [](const Selected& s) { return s.ofCameras([&](const Camera& c) { return c.eye.z - s.elevation; }); },
        [this](const Home& home, const Elements& e, double height) {
          const double floor = link().editor().elevation();
          return changeCameras(home, e, [&](Camera& c) { c.eye.z = floor + height; });
        });
    addPlace({"cameraX", QT_TRANSLATE_NOOP("idap", "X"), QT_TRANSLATE_NOOP("idap", "Move"),
              QT_TRANSLATE_NOOP("idap", "Its eye, to the right of the origin.")},
             &Vec3::x);
    addPlace({"cameraY", QT_TRANSLATE_NOOP("idap", "Y"), QT_TRANSLATE_NOOP("idap", "Move"),
              QT_TRANSLATE_NOOP("idap", "Its eye, up the plan from the origin.")},
             &Vec3::y);
    addAngle(
        {"cameraYaw", QT_TRANSLATE_NOOP("idap", "Direction"), QT_TRANSLATE_NOOP("idap", "Turn"),
         QT_TRANSLATE_NOOP("idap", "Counter-clockwise from looking up the plan.")},
        [](const Selected& s) { return s.ofCameras([](const Camera& c) { return positiveDegrees(c.yaw); }); },
        [](const Home& home, const Elements& e, double angle) {
          return changeCameras(home, e, [&](Camera& c) { c.yaw = radians(angle); });
        });
    addNumber(
        {"cameraPitch", QT_TRANSLATE_NOOP("idap", "Looks down"), QT_TRANSLATE_NOOP("idap", "Tilt"),
         QT_TRANSLATE_NOOP("idap", "0 looks level, 90 straight down, negative up.")},
        QStringLiteral("°"), 2,
        [](const Selected& s) { return s.ofCameras([](const Camera& c) { return signedDegrees(c.pitch); }); },
        [](const Home& home, const Elements& e, double angle) {
          return changeCameras(home, e, [&](Camera& c) { c.pitch = radians(angle); });
        },
        [](const Selected&) { return std::pair(-90.0, 90.0); });
    addLens();
    addTime();
  }

 private:
  void addPlace(const RowText& text, double Vec3::*axis) {
    addLength(
        text,
        [axis](const Selected& s) { return s.ofCameras([axis](const Camera& c) { return c.eye.*axis; }); },
        [axis](const Home& home, const Elements& e, double at) {
          return changeCameras(home, e, [&](Camera& c) { c.eye.*axis = at; });
        });
  }

  void addLens() {
    addChoice(
        {"cameraLens", QT_TRANSLATE_NOOP("idap", "Lens"), QT_TRANSLATE_NOOP("idap", "Change lens"),
         QT_TRANSLATE_NOOP("idap",
                           "Parallel keeps sizes, as plans do; fisheye and panorama see all around.")},
        {QT_TRANSLATE_NOOP("idap", "Usual"), QT_TRANSLATE_NOOP("idap", "Parallel"),
         QT_TRANSLATE_NOOP("idap", "Fisheye"), QT_TRANSLATE_NOOP("idap", "Panorama")},
        [](const Selected& s) {
          return s.ofCameras([](const Camera& c) { return static_cast<int>(c.lens); });
        },
        [](const Home& home, const Elements& e, int lens) {
          return changeCameras(home, e, [lens](Camera& c) {
            c.lens = static_cast<Lens>(lens);
            if (isFlat(c.lens)) c.fieldOfView = std::min(c.fieldOfView, 3.0);
          });
        });
    addNumber(
        {"cameraFieldOfView", QT_TRANSLATE_NOOP("idap", "Field of view"),
         QT_TRANSLATE_NOOP("idap", "Change field of view"),
         QT_TRANSLATE_NOOP("idap", "From the left edge of the picture to the right: 60 to 75 suits rooms.")},
        QStringLiteral("°"), 1,
        [](const Selected& s) { return s.ofCameras([](const Camera& c) { return degrees(c.fieldOfView); }); },
        [](const Home& home, const Elements& e, double angle) {
          return changeCameras(home, e, [&](Camera& c) { c.fieldOfView = radians(angle); });
        },
        [](const Selected& s) {
          const auto flat = s.ofCameras([](const Camera& c) { return isFlat(c.lens); });
          return std::pair(1.0, flat.value || flat.mixed ? 170.0 : 360.0);
        });
    addNumber(
        {"cameraFocalLength", QT_TRANSLATE_NOOP("idap", "Focal length"),
         QT_TRANSLATE_NOOP("idap", "Change focal length"),
         QT_TRANSLATE_NOOP("idap", "The same as on a 35 mm camera: 24 wide, 35 usual for rooms, 50 normal.")},
        QStringLiteral(" mm"), 1,
        [](const Selected& s) {
          Common<double> common;
          for (const CameraId id : s.all.cameras)
            if (const Camera* c = s.home.cameras.find(id); c && c->lens == Lens::Pinhole)
              common.add(kHalfFrame / std::tan(c->fieldOfView / 2));
          return common;
        },
        [](const Home& home, const Elements& e, double length) {
          return changeCameras(home, e, [&](Camera& c) {
            if (c.lens == Lens::Pinhole) c.fieldOfView = 2 * std::atan(kHalfFrame / length);
          });
        },
        [](const Selected&) { return std::pair(2.0, 1000.0); });
  }

  void addTime() {
    addCheck(
        {"cameraOwnTime", QT_TRANSLATE_NOOP("idap", "A time of its own"),
         QT_TRANSLATE_NOOP("idap", "Change time"),
         QT_TRANSLATE_NOOP("idap", "Otherwise its pictures are of the home's time.")},
        [](const Selected& s) { return s.ofCameras([](const Camera& c) { return c.time.has_value(); }); },
        [](const Home& home, const Elements& e, bool on) {
          return changeCameras(home, e, [&](Camera& c) {
            if (!on)
              c.time.reset();
            else if (!c.time)
              c.time = home.site.time;
          });
        });
    auto* time = new TimeField(body());
    const RowText text{"cameraTime", QT_TRANSLATE_NOOP("idap", "Time"),
                       QT_TRANSLATE_NOOP("idap", "Change time"),
                       QT_TRANSLATE_NOOP("idap", "The moment of its pictures: it sets the sun.")};
    addRow(text, time);
    connect(time, &TimeField::timeChosen, this, [this, text](qint64 utc) {
      apply<std::int64_t>(
          text,
          [](const Home& home, const Elements& e, const std::int64_t& moment) {
            return changeCameras(home, e, [&](Camera& c) { c.time = moment; });
          },
          utc);
    });
    onRefresh([this, time](const Selected& s) {
      const auto moment = s.ofCameras([](const Camera& c) { return c.time; });
      setRowShown(time, moment.any && !moment.mixed && moment.value.has_value());
      if (moment.value) time->setTime(*moment.value, s.home.site.timeZone);
    });
  }
};

}  // namespace

SectionEntry cameraSection() {
  return {[](const Selected& s) { return s.kind == ElementKind::Camera; },
          [](PanelLink& link, QWidget* parent) -> Section* { return new CameraSection(link, parent); }};
}

}  // namespace idap
