#pragma once

#include "app/ui/theme/theme.h"

#include <QSize>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <variant>

namespace app {

/// A film of a run, as `springstep film` makes it.
struct FilmRequest
{
    QString file;
    QString out; ///< the name of a WebM or GIF file, or that of a PNG for each frame
    QSize size{640, 480};
    Scheme scheme = Scheme::light;
    std::int64_t from = 0;
    std::optional<std::int64_t> to; ///< empty: as far as the file says
    double rate = 30.0;             ///< frames a second
};

/// What `springstep film` is to make; or the exit code, when that is settled: for help and for bad use.
std::variant<int, FilmRequest> readFilmArguments(const QStringList &arguments);

}
