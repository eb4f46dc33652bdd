#pragma once

#include <QDialog>

namespace app {

/// A dialog that shows the program's version, its licence and the libraries it is built with.
class AboutPage : public QDialog
{
    Q_OBJECT

public:
    explicit AboutPage(QWidget *parent = nullptr);

    /// Opens the dialog in front, centred over its parent window.
    void open() override;

private:
    QWidget *head();
    QWidget *libraries();
    QWidget *buttons();
};

}
