// What every piece has, furniture, doors and windows alike: name, place, size, rotation, what is known of it.
#include <QCheckBox>
#include <QSettings>

#include "model/edits/piece_edits.h"
#include "studio/properties/sections.h"
#include "studio/widgets/number_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kSmallest = 0.001, kLargest = 1000;  // m

bool onlyPieces(const Selected& s) { return s.kind == ElementKind::Piece; }

class PieceSection : public Section {
 public:
  PieceSection(PanelLink& link, QWidget* parent)
      : Section(link, "pieceSection", QT_TRANSLATE_NOOP("idap", "General"), parent) {
    addText(
        {"pieceName", QT_TRANSLATE_NOOP("idap", "Name"), QT_TRANSLATE_NOOP("idap", "Change name"),
         QT_TRANSLATE_NOOP("idap", "How it is called in lists and on the plan.")},
        [](const Selected& s) { return s.ofPieces([](const Piece& p) { return p.name; }); },
        [](const Home& home, const Elements& e, const std::string& name) {
          return changePieces(home, e, [&](Piece& p) { p.name = name; });
        });
    addCheck(
        {"pieceNameVisible", QT_TRANSLATE_NOOP("idap", "Name on the plan"),
         QT_TRANSLATE_NOOP("idap", "Show name"),
         QT_TRANSLATE_NOOP("idap", "Writes the name over the piece on the plan.")},
        [](const Selected& s) { return s.ofPieces([](const Piece& p) { return p.nameVisible; }); },
        [](const Home& home, const Elements& e, bool on) {
          return changePieces(home, e, [&](Piece& p) { p.nameVisible = on; });
        });
    addCheck(
        {"pieceVisible", QT_TRANSLATE_NOOP("idap", "Visible"), QT_TRANSLATE_NOOP("idap", "Change visibility"),
         QT_TRANSLATE_NOOP("idap", "Hidden pieces are on no plan and in no picture.")},
        [](const Selected& s) { return s.ofPieces([](const Piece& p) { return p.visible; }); },
        [](const Home& home, const Elements& e, bool on) {
          return changePieces(home, e, [&](Piece& p) { p.visible = on; });
        });
    addCheck(
        {"pieceLocked", QT_TRANSLATE_NOOP("idap", "Locked"), QT_TRANSLATE_NOOP("idap", "Change lock"),
         QT_TRANSLATE_NOOP("idap", "A locked piece is not moved by the pointer.")},
        [](const Selected& s) { return s.ofPieces([](const Piece& p) { return p.locked; }); },
        [](const Home& home, const Elements& e, bool on) {
          return changePieces(home, e, [&](Piece& p) { p.locked = on; });
        });
  }
};

class PlaceSection : public Section {
 public:
  PlaceSection(PanelLink& link, QWidget* parent)
      : Section(link, "placeSection", QT_TRANSLATE_NOOP("idap", "Place"), parent) {
    // One in a wall has its place along the wall: openingSection.
    const auto free = [](const Selected& s, double Vec3::*axis) {
      Common<double> common;
      for (const OpeningId id : s.all.openings)
        if (const Opening* opening = s.home.openings.find(id); opening && opening->wall) return common;
      return s.ofPieces([axis](const Piece& p) { return p.position.*axis; });
    };
    const auto put = [](double Vec3::*axis) {
      return [axis](const Home& home, const Elements& e, double at) {
        return changePieces(home, e, [&](Piece& p) { p.position.*axis = at; });
      };
    };
    addLength(
        {"pieceX", QT_TRANSLATE_NOOP("idap", "X"), QT_TRANSLATE_NOOP("idap", "Move"),
         QT_TRANSLATE_NOOP("idap", "Its middle, to the right of the origin."), true},
        [free](const Selected& s) { return free(s, &Vec3::x); }, put(&Vec3::x));
    addLength(
        {"pieceY", QT_TRANSLATE_NOOP("idap", "Y"), QT_TRANSLATE_NOOP("idap", "Move"),
         QT_TRANSLATE_NOOP("idap", "Its middle, up the plan from the origin."), true},
        [free](const Selected& s) { return free(s, &Vec3::y); }, put(&Vec3::y));
    addLength(
        {"pieceElevation", QT_TRANSLATE_NOOP("idap", "Elevation"), QT_TRANSLATE_NOOP("idap", "Raise"),
         QT_TRANSLATE_NOOP("idap", "Its base above the floor; of a window the height of its sill.")},
        [](const Selected& s) { return s.ofPieces([](const Piece& p) { return p.position.z; }); },
        put(&Vec3::z));
  }
};

class SizeSection : public Section {
 public:
  SizeSection(PanelLink& panelLink, QWidget* parent)
      : Section(panelLink, "sizeSection", QT_TRANSLATE_NOOP("idap", "Size"), parent) {
    add({"pieceWidth", QT_TRANSLATE_NOOP("idap", "Width"), QT_TRANSLATE_NOOP("idap", "Change width"),
         QT_TRANSLATE_NOOP("idap", "From its left to its right. Sums are welcome: 120+15."), true},
        &Vec3::x);
    add({"pieceDepth", QT_TRANSLATE_NOOP("idap", "Depth"), QT_TRANSLATE_NOOP("idap", "Change depth"),
         QT_TRANSLATE_NOOP("idap", "From its front to its back."), true},
        &Vec3::y);
    add({"pieceHeight", QT_TRANSLATE_NOOP("idap", "Height"), QT_TRANSLATE_NOOP("idap", "Change height"),
         QT_TRANSLATE_NOOP("idap", "From its base to its top."), true},
        &Vec3::z);
    keep_ = new QCheckBox(body());
    keep_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    keep_->setChecked(QSettings().value(QStringLiteral("properties/keepProportions"), false).toBool());
    connect(keep_, &QCheckBox::toggled, this,
            [](bool on) { QSettings().setValue(QStringLiteral("properties/keepProportions"), on); });
    addRow({"keepProportions", QT_TRANSLATE_NOOP("idap", "Keep proportions"), "",
            QT_TRANSLATE_NOOP("idap", "The other two sizes change along.")},
           keep_);
    addCheck(
        {"pieceMirrored", QT_TRANSLATE_NOOP("idap", "Mirrored"), QT_TRANSLATE_NOOP("idap", "Mirror"),
         QT_TRANSLATE_NOOP("idap", "Left and right exchanged.")},
        [](const Selected& s) { return s.ofPieces([](const Piece& p) { return p.mirrored; }); },
        [](const Home& home, const Elements& e, bool on) {
          return changePieces(home, e, [&](Piece& p) { p.mirrored = on; });
        });
  }

 private:
  void add(const RowText& text, double Vec3::*axis) {
    addLength(
        text,
        [axis](const Selected& s) { return s.ofPieces([axis](const Piece& p) { return p.size.*axis; }); },
        [this, axis](const Home& home, const Elements& e, double size) {
          const bool keep = keep_->isChecked();
          return changePieces(home, e, [&](Piece& p) { resize(p, axis, size, keep, home); });
        },
        [this, axis](const Selected& s) {
          std::pair<double, double> range{kSmallest, kLargest};
          for (const Piece* piece : s.pieces()) {
            const auto [low, high] = limits(*piece, axis, s.home);
            range.first = std::max(range.first, low);
            range.second = std::min(range.second, high);
          }
          // Pieces of very different limits: each keeps to its own.
          if (range.first > range.second) range = {kSmallest, kLargest};
          return range;
        });
  }

  std::pair<double, double> limits(const Piece& piece, double Vec3::*axis, const Home& home) {
    const PieceFacts* facts = link().facts(piece, home);
    if (!facts || !facts->piece) return {kSmallest, kLargest};
    const double low = facts->piece->minSize.*axis, high = facts->piece->maxSize.*axis;
    // A piece that came with a size beyond the limits may keep it.
    return {low > 0 ? std::min(low, piece.size.*axis) : kSmallest,
            high > 0 ? std::max(high, piece.size.*axis) : kLargest};
  }

  void resize(Piece& piece, double Vec3::*axis, double size, bool keep, const Home& home) {
    const Piece before = piece;
    const double factor = size / (piece.size.*axis);
    for (double Vec3::*each : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      if (each != axis && !keep) continue;
      const auto [low, high] = limits(before, each, home);
      piece.size.*each = std::clamp(each == axis ? size : before.size.*each * factor, low, high);
    }
  }

  QCheckBox* keep_;
};

class RotationSection : public Section {
 public:
  RotationSection(PanelLink& link, QWidget* parent)
      : Section(link, "rotationSection", QT_TRANSLATE_NOOP("idap", "Rotation"), parent) {
    addAngle(
        {"pieceAngle", QT_TRANSLATE_NOOP("idap", "Angle"), QT_TRANSLATE_NOOP("idap", "Turn"),
         QT_TRANSLATE_NOOP("idap", "Counter-clockwise on the plan, in degrees."), true},
        [](const Selected& s) { return s.ofPieces([](const Piece& p) { return positiveDegrees(p.angle); }); },
        [](const Home& home, const Elements& e, double angle) {
          return changePieces(home, e, [&](Piece& p) { p.angle = radians(angle); });
        });
    addAngle(
        {"piecePitch", QT_TRANSLATE_NOOP("idap", "Pitch"), QT_TRANSLATE_NOOP("idap", "Tilt"),
         QT_TRANSLATE_NOOP("idap", "Tilted forwards: lifts its back."), true},
        [](const Selected& s) {
          return s.ofFurniture([](const Furniture& p) { return signedDegrees(p.pitch); });
        },
        [](const Home& home, const Elements& e, double angle) {
          return changeFurniture(home, e, [&](Furniture& p) { p.pitch = radians(angle); });
        });
    addAngle(
        {"pieceRoll", QT_TRANSLATE_NOOP("idap", "Roll"), QT_TRANSLATE_NOOP("idap", "Roll"),
         QT_TRANSLATE_NOOP("idap", "Tilted to its side."), true},
        [](const Selected& s) {
          return s.ofFurniture([](const Furniture& p) { return signedDegrees(p.roll); });
        },
        [](const Home& home, const Elements& e, double angle) {
          return changeFurniture(home, e, [&](Furniture& p) { p.roll = radians(angle); });
        });
  }
};

QString saidOf(const Selected& s, const char* key) {
  const Common<std::string> common = s.ofPieces([key](const Piece& p) {
    const auto found = p.properties.find(key);
    return found == p.properties.end() ? std::string() : found->second;
  });
  return common.mixed ? QString() : toQt(common.value);
}

class PieceNotesSection : public Section {
 public:
  PieceNotesSection(PanelLink& link, QWidget* parent)
      : Section(link, "pieceNotesSection", QT_TRANSLATE_NOOP("idap", "Price and origin"), parent) {
    NumberField* price = addOptionalNumber(
        {"piecePrice", QT_TRANSLATE_NOOP("idap", "Price"), QT_TRANSLATE_NOOP("idap", "Change price"),
         QT_TRANSLATE_NOOP("idap", "Of one piece, in the home's currency; empty: not known.")},
        2, [](const Selected& s) { return s.ofPieces([](const Piece& p) { return p.price; }); },
        [](const Home& home, const Elements& e, const std::optional<double>& each) {
          return changePieces(home, e, [&](Piece& p) { p.price = each; });
        });
    price->setRange(0, 1e12);
    onRefresh([price](const Selected& s) { price->setUnit(QLatin1Char(' ') + toQt(s.home.currency)); });
    addInfo({"pieceTotal", QT_TRANSLATE_NOOP("idap", "Together"), "", ""}, [](const Selected& s) {
      double total = 0;
      int priced = 0;
      for (const Piece* piece : s.pieces())
        if (piece->price) total += *piece->price, ++priced;
      if (priced < 2) return QString();
      return QString::number(total, 'f', 2) + QLatin1Char(' ') + toQt(s.home.currency);
    });
    addText(
        {"pieceDescription", QT_TRANSLATE_NOOP("idap", "Note"), QT_TRANSLATE_NOOP("idap", "Change note"),
         QT_TRANSLATE_NOOP("idap", "Anything to remember about it: maker, order number.")},
        [](const Selected& s) { return s.ofPieces([](const Piece& p) { return p.description; }); },
        [](const Home& home, const Elements& e, const std::string& note) {
          return changePieces(home, e, [&](Piece& p) { p.description = note; });
        });
    addInfo({"pieceCreator", QT_TRANSLATE_NOOP("idap", "Creator"), "",
             QT_TRANSLATE_NOOP("idap", "Who made the model.")},
            [](const Selected& s) { return saidOf(s, "creator"); });
    addInfo({"pieceLicense", QT_TRANSLATE_NOOP("idap", "Licence"), "",
             QT_TRANSLATE_NOOP("idap", "Under which terms the model may be passed on.")},
            [](const Selected& s) { return saidOf(s, "license"); });
  }
};

}  // namespace

SectionEntry pieceSection() {
  return {onlyPieces,
          [](PanelLink& link, QWidget* parent) -> Section* { return new PieceSection(link, parent); }};
}
SectionEntry placeSection() {
  return {onlyPieces,
          [](PanelLink& link, QWidget* parent) -> Section* { return new PlaceSection(link, parent); }};
}
SectionEntry sizeSection() {
  return {onlyPieces,
          [](PanelLink& link, QWidget* parent) -> Section* { return new SizeSection(link, parent); }};
}
SectionEntry rotationSection() {
  return {onlyPieces,
          [](PanelLink& link, QWidget* parent) -> Section* { return new RotationSection(link, parent); }};
}
SectionEntry pieceNotesSection() {
  return {onlyPieces,
          [](PanelLink& link, QWidget* parent) -> Section* { return new PieceNotesSection(link, parent); }};
}

}  // namespace idap
