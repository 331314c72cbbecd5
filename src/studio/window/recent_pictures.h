// The little pictures of recent files and templates: their plans, kept in the user's cache.
#pragma once

#include <QImage>
#include <QString>

namespace idap {

class PlanView;

inline constexpr int kRecentWidth = 240, kRecentHeight = 150;  // pixels

// Where the picture of a file is kept.
QString recentPicture(const QString& file);
// Draws the plan that the view shows and keeps it for the file.
void keepRecentPicture(const QString& file, const PlanView& view);
QImage planPicture(const PlanView& view, int width, int height);

}  // namespace idap
