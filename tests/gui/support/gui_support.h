// What tests of widgets share: waiting, looking.
#pragma once

#include <QWidget>
#include <functional>

namespace idap::test {

// Runs the event loop until the condition holds; false when it does not within the time.
bool waitFor(const std::function<bool()>& condition, int milliseconds = 5000);

// Saves a picture of the widget into $IDAP_SHOTS, where that is set, to be looked at.
void shoot(QWidget& widget, const char* name);

}  // namespace idap::test
