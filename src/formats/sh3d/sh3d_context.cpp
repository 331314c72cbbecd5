#include "formats/sh3d/sh3d_context.h"

#include <cmath>

#include "catalog/model_file_material.h"

namespace idap {

LevelId Sh3dContext::levelOf(const Sh3dElement& element) {
  if (!element.has("level")) return {};
  const auto found = levels.find(element.text("level"));
  if (found != levels.end()) return found->second;
  report.add(element.place(), "its level does not exist: put on the ground level");
  return levels.empty() ? LevelId{} : home.levels.begin()->first;
}

double sh3dAngle(double clockwise) { return clockwise == 0 ? 0 : std::remainder(-clockwise, 2 * kPi); }

std::optional<TextureRef> sh3dTexture(Sh3dContext& context, const Sh3dElement& element,
                                      const char* attribute) {
  const auto texture = element.child("texture", attribute);
  if (!texture) return std::nullopt;
  TextureRef ref;
  ref.asset = context.contents.picture(texture->text("image"), element.place(), context.report);
  if (ref.asset.empty()) return std::nullopt;
  const double scale = texture->number("scale", 1);
  Vec2 size{texture->length("width", 1), texture->length("height", 1)};
  if (!(size.x > 0)) size.x = 1;  // -1 stands for "as in the model"
  if (!(size.y > 0)) size.y = 1;
  ref.size = scale > 0 ? size * scale : size;
  ref.offset = {texture->number("xOffset", 0) * ref.size.x, texture->number("yOffset", 0) * ref.size.y};
  ref.angle = sh3dAngle(texture->number("angle", 0));
  ref.fitToArea = texture->flag("fittingArea", false);
  return ref;
}

Finish sh3dFinish(Sh3dContext& context, const Sh3dElement& element, const char* color, const char* texture,
                  const char* shininess) {
  Finish finish;
  finish.texture = sh3dTexture(context, element, texture);
  if (!finish.texture) finish.color = element.color(color);
  if (shininess)
    if (const auto s = element.number(shininess); s && *s > 0)
      finish.roughness = roughnessOfPhong(*s, *s * 128);
  return finish;
}

TextStyle sh3dTextStyle(const Sh3dElement& element, const char* attribute) {
  TextStyle style;
  const auto text = element.child("textStyle", attribute);
  if (!text) return style;
  style.font = text->text("fontName");
  style.size = text->length("fontSize", style.size);
  style.bold = text->flag("bold", false);
  style.italic = text->flag("italic", false);
  const std::string alignment = text->text("alignment");
  if (alignment == "LEFT") style.alignment = TextAlignment::Left;
  if (alignment == "RIGHT") style.alignment = TextAlignment::Right;
  return style;
}

}  // namespace idap
