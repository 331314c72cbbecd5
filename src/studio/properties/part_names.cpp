#include "studio/properties/part_names.h"

#include <map>

#include "studio/widgets/texts.h"

namespace idap {

namespace {

// "seatHeight" and "steel_leg 2" as one would write them.
QString tidied(const std::string& name) {
  QString words;
  for (const QChar c : toQt(name)) {
    if (c.isUpper() && !words.isEmpty() && words.back().isLower()) words += QLatin1Char(' ');
    words += c == QLatin1Char('_') || c == QLatin1Char('-') ? QLatin1Char(' ') : c.toLower();
  }
  words = words.simplified();
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words;
}

QString nameIn(const std::map<std::string, const char*>& names, const std::string& name) {
  const auto found = names.find(name);
  return found == names.end() ? tidied(name) : translated(found->second);
}

}  // namespace

QString partName(const std::string& slot) {
  static const std::map<std::string, const char*> kNames{
      {"accent", QT_TRANSLATE_NOOP("idap", "Accent")},
      {"apple", QT_TRANSLATE_NOOP("idap", "Apple")},
      {"armrests", QT_TRANSLATE_NOOP("idap", "Armrests")},
      {"back", QT_TRANSLATE_NOOP("idap", "Back")},
      {"baluster", QT_TRANSLATE_NOOP("idap", "Baluster")},
      {"base", QT_TRANSLATE_NOOP("idap", "Base")},
      {"basket", QT_TRANSLATE_NOOP("idap", "Basket")},
      {"bedding", QT_TRANSLATE_NOOP("idap", "Bedding")},
      {"blade", QT_TRANSLATE_NOOP("idap", "Blade")},
      {"body", QT_TRANSLATE_NOOP("idap", "Body")},
      {"book-a", QT_TRANSLATE_NOOP("idap", "Books 1")},
      {"book-b", QT_TRANSLATE_NOOP("idap", "Books 2")},
      {"book-c", QT_TRANSLATE_NOOP("idap", "Books 3")},
      {"book-d", QT_TRANSLATE_NOOP("idap", "Books 4")},
      {"border", QT_TRANSLATE_NOOP("idap", "Border")},
      {"bowl", QT_TRANSLATE_NOOP("idap", "Bowl")},
      {"bracket", QT_TRANSLATE_NOOP("idap", "Bracket")},
      {"cactus", QT_TRANSLATE_NOOP("idap", "Cactus")},
      {"candle", QT_TRANSLATE_NOOP("idap", "Candle")},
      {"cane", QT_TRANSLATE_NOOP("idap", "Cane")},
      {"carcass", QT_TRANSLATE_NOOP("idap", "Carcass")},
      {"case", QT_TRANSLATE_NOOP("idap", "Case")},
      {"castors", QT_TRANSLATE_NOOP("idap", "Castors")},
      {"ceramic", QT_TRANSLATE_NOOP("idap", "Ceramic")},
      {"chrome", QT_TRANSLATE_NOOP("idap", "Chrome")},
      {"cone", QT_TRANSLATE_NOOP("idap", "Cone")},
      {"curtain", QT_TRANSLATE_NOOP("idap", "Curtain")},
      {"dark-glass", QT_TRANSLATE_NOOP("idap", "Dark glass")},
      {"dial", QT_TRANSLATE_NOOP("idap", "Dial")},
      {"door", QT_TRANSLATE_NOOP("idap", "Door")},
      {"drain", QT_TRANSLATE_NOOP("idap", "Drain")},
      {"drops", QT_TRANSLATE_NOOP("idap", "Drops")},
      {"duvet", QT_TRANSLATE_NOOP("idap", "Duvet")},
      {"fabric", QT_TRANSLATE_NOOP("idap", "Fabric")},
      {"face", QT_TRANSLATE_NOOP("idap", "Face")},
      {"filter", QT_TRANSLATE_NOOP("idap", "Filter")},
      {"fitting", QT_TRANSLATE_NOOP("idap", "Fitting")},
      {"flame", QT_TRANSLATE_NOOP("idap", "Flame")},
      {"flashing", QT_TRANSLATE_NOOP("idap", "Flashing")},
      {"frame", QT_TRANSLATE_NOOP("idap", "Frame")},
      {"fringe", QT_TRANSLATE_NOOP("idap", "Fringe")},
      {"front", QT_TRANSLATE_NOOP("idap", "Front")},
      {"glass", QT_TRANSLATE_NOOP("idap", "Glass")},
      {"grass", QT_TRANSLATE_NOOP("idap", "Grass")},
      {"grate", QT_TRANSLATE_NOOP("idap", "Grate")},
      {"grille", QT_TRANSLATE_NOOP("idap", "Grille")},
      {"handle", QT_TRANSLATE_NOOP("idap", "Handle")},
      {"hands", QT_TRANSLATE_NOOP("idap", "Hands")},
      {"heart", QT_TRANSLATE_NOOP("idap", "Heart")},
      {"hob", QT_TRANSLATE_NOOP("idap", "Hob")},
      {"hob-mark", QT_TRANSLATE_NOOP("idap", "Marks on the hob")},
      {"holder", QT_TRANSLATE_NOOP("idap", "Holder")},
      {"inside", QT_TRANSLATE_NOOP("idap", "Inside")},
      {"joints", QT_TRANSLATE_NOOP("idap", "Joints")},
      {"keys", QT_TRANSLATE_NOOP("idap", "Keys")},
      {"knob", QT_TRANSLATE_NOOP("idap", "Knob")},
      {"leaf", QT_TRANSLATE_NOOP("idap", "Leaf")},
      {"legs", QT_TRANSLATE_NOOP("idap", "Legs")},
      {"lemon", QT_TRANSLATE_NOOP("idap", "Lemon")},
      {"louvre", QT_TRANSLATE_NOOP("idap", "Louvre")},
      {"mat", QT_TRANSLATE_NOOP("idap", "Mat")},
      {"mattress", QT_TRANSLATE_NOOP("idap", "Mattress")},
      {"metal", QT_TRANSLATE_NOOP("idap", "Metal")},
      {"mirror", QT_TRANSLATE_NOOP("idap", "Mirror glass")},
      {"nails", QT_TRANSLATE_NOOP("idap", "Nails")},
      {"pad", QT_TRANSLATE_NOOP("idap", "Pad")},
      {"pads", QT_TRANSLATE_NOOP("idap", "Pads")},
      {"panel", QT_TRANSLATE_NOOP("idap", "Panel")},
      {"paper", QT_TRANSLATE_NOOP("idap", "Paper")},
      {"pear", QT_TRANSLATE_NOOP("idap", "Pear")},
      {"petal", QT_TRANSLATE_NOOP("idap", "Petal")},
      {"picture", QT_TRANSLATE_NOOP("idap", "Picture")},
      {"pillow", QT_TRANSLATE_NOOP("idap", "Pillow")},
      {"plate", QT_TRANSLATE_NOOP("idap", "Plate")},
      {"plinth", QT_TRANSLATE_NOOP("idap", "Plinth")},
      {"post", QT_TRANSLATE_NOOP("idap", "Post")},
      {"pot", QT_TRANSLATE_NOOP("idap", "Pot")},
      {"rail", QT_TRANSLATE_NOOP("idap", "Rail")},
      {"riser", QT_TRANSLATE_NOOP("idap", "Riser")},
      {"rod", QT_TRANSLATE_NOOP("idap", "Rod")},
      {"rug", QT_TRANSLATE_NOOP("idap", "Rug")},
      {"sash", QT_TRANSLATE_NOOP("idap", "Sash")},
      {"screen", QT_TRANSLATE_NOOP("idap", "Screen")},
      {"seal", QT_TRANSLATE_NOOP("idap", "Seal")},
      {"seat", QT_TRANSLATE_NOOP("idap", "Seat")},
      {"shade", QT_TRANSLATE_NOOP("idap", "Shade")},
      {"shelf", QT_TRANSLATE_NOOP("idap", "Shelf")},
      {"shell", QT_TRANSLATE_NOOP("idap", "Shell")},
      {"sill", QT_TRANSLATE_NOOP("idap", "Sill")},
      {"sink", QT_TRANSLATE_NOOP("idap", "Sink")},
      {"soil", QT_TRANSLATE_NOOP("idap", "Soil")},
      {"spines", QT_TRANSLATE_NOOP("idap", "Spines")},
      {"stand", QT_TRANSLATE_NOOP("idap", "Stand")},
      {"steel", QT_TRANSLATE_NOOP("idap", "Steel")},
      {"stem", QT_TRANSLATE_NOOP("idap", "Stem")},
      {"string", QT_TRANSLATE_NOOP("idap", "Stringer")},
      {"tap", QT_TRANSLATE_NOOP("idap", "Tap")},
      {"threshold", QT_TRANSLATE_NOOP("idap", "Threshold")},
      {"throw", QT_TRANSLATE_NOOP("idap", "Throw")},
      {"top", QT_TRANSLATE_NOOP("idap", "Top")},
      {"towel", QT_TRANSLATE_NOOP("idap", "Towel")},
      {"tray", QT_TRANSLATE_NOOP("idap", "Tray")},
      {"tread", QT_TRANSLATE_NOOP("idap", "Tread")},
      {"tub", QT_TRANSLATE_NOOP("idap", "Tub")},
      {"vase", QT_TRANSLATE_NOOP("idap", "Vase")},
      {"wall", QT_TRANSLATE_NOOP("idap", "Wall")},
      {"wax", QT_TRANSLATE_NOOP("idap", "Wax")},
      {"wick", QT_TRANSLATE_NOOP("idap", "Wick")},
      {"wood", QT_TRANSLATE_NOOP("idap", "Wood")},
      {"worktop", QT_TRANSLATE_NOOP("idap", "Worktop")},
  };
  return nameIn(kNames, slot);
}

QString parameterName(const PieceParameter& parameter) {
  return parameter.label.empty() || parameter.label == parameter.name ? tidied(parameter.name)
                                                                      : translated(parameter.label.c_str());
}

}  // namespace idap
