#pragma once

#include <QString>

#include <utility>
#include <vector>

namespace app {

/// Returns the texts of a web page's controls, by the names under which page/player.js finds them.
std::vector<std::pair<QString, QString>> pageWords();

/// Why a browser cannot show the run.
enum class NoRun { noScripts, oldBrowser, damaged };

/// Returns the sentence that the page shows instead of the run.
QString noRunText(NoRun why);

}
