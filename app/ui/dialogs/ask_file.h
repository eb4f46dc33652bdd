#pragma once

#include <QString>

class QWidget;

namespace app {

/// Asks where to save a file, and suggests `name`. A name without a folder goes to the folder that was last
/// used to save or open a file. A typed name without an extension gets the extension of `name`. Asks before
/// an existing file is replaced. Returns the path, or an empty text if the learner cancels.
QString askWhereToSave(QWidget *parent, const QString &title, const QString &name, const QString &filter);

/// Asks which file to open, starting in the folder of `path` if that is not empty. Returns the path, or an
/// empty text if the learner cancels.
QString askWhatToOpen(QWidget *parent, const QString &title, const QString &path, const QString &filter);

}
