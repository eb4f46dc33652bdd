#pragma once

#include "app/ui/theme/theme.h"

#include <QDialog>

namespace app {

/// Tells which program this is: its version, its licence, and what it is built with.
class AboutPage : public QDialog
{
    Q_OBJECT

public:
    explicit AboutPage(const Theme &theme, QWidget *parent = nullptr);

    /// Opens it in front, over its window.
    void open() override;

private:
    QWidget *head();
    QWidget *libraries();
    QWidget *buttons();

    const Theme &m_theme;
};

}
