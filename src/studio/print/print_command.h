// `idap print`: a print job without a window, as the arguments after --print-job say it.
#pragma once

#include <QStringList>

namespace idap {

// Prints and gives the exit status: 0 done, 1 failed, 2 wrong usage; what went wrong goes to standard error.
int runPrintCommand(const QStringList& arguments);

}  // namespace idap
