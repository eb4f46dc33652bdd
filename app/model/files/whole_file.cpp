#include "app/model/files/whole_file.h"

#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

namespace app {

namespace {

struct WholeFileText
{
    Q_DECLARE_TR_FUNCTIONS(WholeFileText)
};

}

QByteArray readWholeFile(const QString &path, qsizetype largest)
{
    const QFileInfo info(path);
    if (info.isDir())
        throw UserError(WholeFileText::tr("%1: this is a folder; give a file.").arg(shownPath(path)));
    if (!info.exists())
        throw UserError(
            WholeFileText::tr("%1: there is no such file; check its name and folder.").arg(shownPath(path)));
    QFile file(path);
    // Pipes and devices do not report a size in advance.
    const bool isLarge = info.size() > largest;
    const bool isOpen = !isLarge && file.open(QIODevice::ReadOnly);
    const QByteArray content = isOpen ? file.read(largest + 1) : QByteArray();
    if (isLarge || content.size() > largest)
        throw UserError(WholeFileText::tr("%1: the file is larger than %2 MiB, the maximum.")
                            .arg(shownPath(path), QString::number(largest >> 20)));
    if (file.error() != QFileDevice::NoError)
        throw UserError(WholeFileText::tr("%1: the file could not be read: %2.")
                            .arg(shownPath(path), oneLine(file.errorString())));
    return content;
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
