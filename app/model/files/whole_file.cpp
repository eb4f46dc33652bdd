#include "app/model/files/whole_file.h"

#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"

#include <QCoreApplication>
#include <QSaveFile>

namespace app {

namespace {

struct WholeFileText
{
    Q_DECLARE_TR_FUNCTIONS(WholeFileText)
};

}

void writeWholeFile(const QString &path, const QByteArray &content)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.commit())
        throw UserError(
            WholeFileText::tr("%1: the file could not be written: %2. Choose another folder or name.")
                .arg(shownPath(path), oneLine(file.errorString())));
}

}
