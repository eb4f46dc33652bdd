#include "app/ui/dialogs/file_row.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QPushButton>

namespace app {

namespace {

struct FileRowText
{
    Q_DECLARE_TR_FUNCTIONS(FileRowText)
};

}

FileRow makeFileRow(const QString &help, QWidget *parent)
{
    const FileRow row{new QLineEdit(parent), new QPushButton(FileRowText::tr("&Choose…"), parent)};
    row.field->setAccessibleName(FileRowText::tr("File"));
    row.field->setToolTip(help);
    row.choose->setToolTip(FileRowText::tr("Choose a folder and a name"));
    row.choose->setAutoDefault(false);
    return row;
}

}
