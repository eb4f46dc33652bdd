#include "app/ui/dialogs/ask_file.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

namespace app {

namespace {

const char *const folderKey = "files/folder";

QString lastFolder()
{
    const QString last = QSettings().value(folderKey).toString();
    return !last.isEmpty() && QDir(last).exists() ? last : standardFolder(QStandardPaths::DocumentsLocation);
}

QString folderFor(const QString &path)
{
    const QFileInfo info(path);
    return path.isEmpty() || info.isRelative() ? lastFolder() : info.absolutePath();
}

/// Returns the chosen path and remembers its folder, or returns an empty text if the learner cancels.
QString chosenIn(QFileDialog &dialog)
{
    if (dialog.exec() != QDialog::Accepted)
        return {};
    const QString path = dialog.selectedFiles().value(0);
    QSettings().setValue(folderKey, QFileInfo(path).absolutePath());
    return path;
}

}

QString standardFolder(QStandardPaths::StandardLocation kind)
{
    const QString folder = QStandardPaths::writableLocation(kind);
    return !folder.isEmpty() && QDir(folder).exists() ? folder : QDir::homePath();
}

QString askWhereToSave(QWidget *parent, const QString &title, const QString &name, const QString &filter)
{
    const QFileInfo suggested(name);
    QFileDialog dialog(parent, title, folderFor(name), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setDefaultSuffix(suggested.suffix());
    dialog.selectFile(suggested.fileName());
    return chosenIn(dialog);
}

QString askWhatToOpen(QWidget *parent, const QString &title, const QString &path, const QString &filter)
{
    QFileDialog dialog(parent, title, folderFor(path), filter);
    dialog.setFileMode(QFileDialog::ExistingFile);
    return chosenIn(dialog);
}

}
