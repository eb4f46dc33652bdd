#pragma once

#include <QString>

#include <utility>
#include <vector>

namespace app {

/// Returns the texts of a web page's controls, by the names under which page/player.js finds them.
std::vector<std::pair<QString, QString>> pageWords();

/// Returns the sentences that a page shows if a browser cannot show the run, by their names in page/player.html.
std::vector<std::pair<QString, QString>> noRunWords();

}
