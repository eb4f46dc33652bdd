#pragma once

#include <QStackedWidget>

namespace app {

/// The lessons, or the tools of the sandbox in their place.
class LeftPages : public QStackedWidget
{
    Q_OBJECT

public:
    explicit LeftPages(QWidget *parent);

    /// Takes ownership of the page.
    void setLessons(QWidget &page);
    /// Takes ownership of the page.
    void setTools(QWidget &page);
    void showLessons() { setPage(*m_lessons); }
    void showTools() { setPage(*m_tools); }

private:
    void setPage(QWidget &page);

    QWidget *m_lessons = nullptr;
    QWidget *m_tools = nullptr;
};

}
