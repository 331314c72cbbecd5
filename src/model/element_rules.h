// The rules of each kind of element, for checking (const elements) and mending (others) alike.
#pragma once

#include "model/judge.h"

namespace idap {

// Each is defined for T and const T.
void judge(Level& level, Judge& judge);
void judge(const Level& level, Judge& judge);
void judge(Wall& wall, Judge& judge);
void judge(const Wall& wall, Judge& judge);
void judge(Room& room, Judge& judge);
void judge(const Room& room, Judge& judge);
void judge(Opening& opening, Judge& judge);
void judge(const Opening& opening, Judge& judge);
void judge(Furniture& furniture, Judge& judge);
void judge(const Furniture& furniture, Judge& judge);
void judge(Group& group, Judge& judge);
void judge(const Group& group, Judge& judge);
void judge(Camera& camera, Judge& judge);
void judge(const Camera& camera, Judge& judge);
void judge(Picture& picture, Judge& judge);
void judge(const Picture& picture, Judge& judge);
void judge(Dimension& dimension, Judge& judge);
void judge(const Dimension& dimension, Judge& judge);
void judge(Label& label, Judge& judge);
void judge(const Label& label, Judge& judge);
void judge(Polyline& polyline, Judge& judge);
void judge(const Polyline& polyline, Judge& judge);
void judge(Background& background, Judge& judge);
void judge(const Background& background, Judge& judge);
// What the home holds itself: texts, site, environment.
void judgeFrame(Home& home, Judge& judge);
void judgeFrame(const Home& home, Judge& judge);

}  // namespace idap
