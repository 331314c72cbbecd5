#include "cli/look.h"

#include <fmt/format.h>

#include "cli/arguments.h"
#include "cli/usage_error.h"
#include "render/session/focus.h"

namespace idap::cli {

void Look::describe(CLI::App& app) {
  app.add_option("--exposure", exposure,
                 "Exposure value at ISO 100, as on a camera; without it, chosen from the picture")
      ->check(within(-30, 60))
      ->type_name("EV");
  app.add_option("--tone", tone,
                 "Tone curve: neutral, agx, classic or linear; false: brightness as colour, in stops")
      ->check(CLI::IsMember({"neutral", "agx", "classic", "linear", "false"}));
  app.add_option("--white-balance", whiteBalance,
                 "How far the eye has got used to the light's colour: 0 not at all, 1 wholly (0.75)")
      ->check(within(0, 1));
  app.add_option(
         "--lens", lens,
         "Instead of the point of view's own: perspective, orthographic (no perspective), fisheye, or "
         "360 (all around, for viewers of panoramas)")
      ->check(CLI::IsMember({"perspective", "orthographic", "fisheye", "360"}));
  app.add_flag("--upright", upright, "Keep vertical lines vertical, as with an architect's shift lens");
  app.add_option("--aperture", aperture,
                 "Depth of field of a lens with this f-number, for instance 1.4; without it, all is sharp")
      ->check(within(0.1, 100))
      ->type_name("F");
  app.add_option("--focus", focus,
                 "What is sharp, in metres from the eye; without it, what is in the picture's middle")
      ->check(within(0.01, 1e4))
      ->type_name("M");
  app.add_option("--filter", filter,
                 "Edges: smooth, triangle or box (sharpest, jagged beside bright windows)")
      ->check(CLI::IsMember({"smooth", "triangle", "box"}));
  app.add_flag("--transparent", transparent, "Nothing instead of the sky, for laying over another picture");
}

void Look::check(PictureKind kind) const {
  if (transparent && kind != PictureKind::Png && kind != PictureKind::Exr)
    throw UsageError("--transparent: only .png and .exr can be see-through; let -o end in .png");
}

render::Camera Look::camera(render::Camera c, const render::CompiledScene& scene) const {
  using render::Projection;
  if (lens == "perspective" || lens == "fisheye" || lens == "360") {
    const bool round = c.projection == Projection::Fisheye || c.projection == Projection::Equirectangular;
    c.projection = lens == "fisheye" ? Projection::Fisheye
                   : lens == "360"   ? Projection::Equirectangular
                                     : Projection::Perspective;
    if (lens == "360") {
      c.horizontalFov = 2 * static_cast<float>(kPi);
      // The horizon of a panorama is level whichever way the camera looks.
      const float level = std::hypot(c.forward.x, c.forward.y);
      c.forward = level > 1e-3f ? Vec3f{c.forward.x / level, c.forward.y / level, 0} : Vec3f{0, 1, 0};
      c.up = {0, 0, 1};
    } else if (lens == "fisheye") {
      c.horizontalFov = static_cast<float>(kPi);
    } else if (round) {
      c.horizontalFov = 1.1f;
    }
  }
  if (lens == "orthographic" && c.projection != Projection::Orthographic) {
    c.projection = Projection::Orthographic;
    c.orthographicWidth =
        2 * std::tan(0.5f * std::min(c.horizontalFov, 2.5f)) * render::depthInMiddle(scene, c);
  }
  // --focus is measured from the eye, which for what is in the middle is the way along forward.
  if (upright) c = render::upright(c);
  if (aperture)
    c = render::withAperture(scene, c, static_cast<float>(*aperture), static_cast<float>(focus.value_or(0)));
  return c;
}

void Look::apply(render::RenderSettings& settings) const {
  settings.filter = filter == "box"        ? render::PixelFilter::Box
                    : filter == "triangle" ? render::PixelFilter::Triangle
                                           : render::PixelFilter::BlackmanHarris;
  settings.transparentBackground = transparent;
}

void Look::apply(render::DevelopSettings& settings) const {
  if (exposure) settings.ev = static_cast<float>(*exposure);
  if (whiteBalance) settings.whiteBalance = static_cast<float>(*whiteBalance);
  settings.toneMap = toneMap(tone);
}

std::string Look::words() const {
  return fmt::format("{} {} {} {} {} {}", lens, filter, aperture.value_or(0), focus.value_or(0), upright,
                     transparent);
}

}  // namespace idap::cli
