#pragma once

#include <QStackedWidget>

namespace app {

/// The lessons, or the tools of the sandbox in their place.
class LeftPages : public QStackedWidget
{
    Q_OBJECT

public:
    /// Takes ownership of both pages.
    LeftPages(QWidget *lessons, QWidget *tools, QWidget *parent);

    void showLessons() { setPage(*m_lessons); }
    void showTools() { setPage(*m_tools); }

private:
    void setPage(QWidget &page);

    QWidget *m_lessons;
    QWidget *m_tools;
};

}
