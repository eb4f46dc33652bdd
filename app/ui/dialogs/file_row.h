#pragma once

class QLineEdit;
class QPushButton;
class QString;
class QWidget;

namespace app {

/// A field for the path of a file, and the button that opens a file dialog for it.
struct FileRow
{
    QLineEdit *field;
    QPushButton *choose;
};

/// Returns a field and its button as children of `parent`, which are not in a layout yet. `help` is the tooltip of the
/// field.
FileRow makeFileRow(const QString &help, QWidget *parent);

}
