#include "app/ui/dialogs/ask_file.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace app {

namespace {

const char *const folderKey = "files/folder";

QString lastFolder()
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    for (const QString &folder : {QSettings().value(folderKey).toString(), documents}) {
        if (!folder.isEmpty() && QDir(folder).exists())
            return folder;
    }
    return QDir::homePath();
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
