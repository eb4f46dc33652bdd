#pragma once

#include "app/ui/theme/theme.h"

#include <QDialog>

#include <vector>

class QAction;
class QScrollArea;
class QVBoxLayout;

namespace app {

/// All keys and what the mouse does, in groups. Filled from the window's actions, so that it lists what works.
class HelpPage : public QDialog
{
    Q_OBJECT

public:
    explicit HelpPage(const Theme &theme, QWidget *parent = nullptr);

    /// A group of which there may be something to list; they stand in the order in which they are added.
    void addGroup(const QString &name) { groupCalled(name); }
    /// Lists an action's text and shortcuts; one without shortcuts is left out.
    void addAction(const QString &group, const QAction *action);
    /// Lists what the mouse does: "Drag the timeline", "go anywhere in time".
    void addGesture(const QString &group, const QString &gesture, const QString &effect);

    void setVisible(bool visible) override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    struct Group
    {
        QString name;
        QWidget *box;
        QVBoxLayout *column;
        int rows = 0;
    };

    void arrange();
    /// Makes the page as high as its texts are at the width that they have.
    void makeRoom();
    void addRow(const QString &group, const QString &text, QWidget *caps);
    Group &groupCalled(const QString &name);

    const Theme &m_theme;
    QWidget *m_page;
    QScrollArea *m_area = nullptr;
    QVBoxLayout *m_columns[2]; ///< groups go where there is more room
    std::vector<Group> m_groups;
};

}
