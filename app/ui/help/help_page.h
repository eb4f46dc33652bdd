#pragma once

#include "app/ui/theme/theme.h"

#include <QDialog>

#include <array>
#include <vector>

class QAction;
class QHBoxLayout;
class QScrollArea;
class QVBoxLayout;

namespace app {

/// A dialog that lists all keys and mouse gestures in groups. It is filled from the window's actions, so it
/// lists only keys that work.
class HelpPage : public QDialog
{
    Q_OBJECT

public:
    explicit HelpPage(const Theme &theme, QWidget *parent = nullptr);

    /// Adds a group. Groups are listed in the order in which they are added; a group without entries is
    /// hidden.
    void addGroup(const QString &name) { groupCalled(name); }
    /// Lists an action's text and shortcuts. Actions without shortcuts are left out.
    void addAction(const QString &group, const QAction *action);
    /// Lists a mouse gesture and its effect: "Drag the timeline", "go anywhere in time".
    void addGesture(const QString &group, const QString &gesture, const QString &effect);

    void setVisible(bool visible) override;
    /// Arranges the groups and sets the size, for a screen of this size in px.
    void fitTo(QSize screen);

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

    /// Shares the groups among `columns`. Returns the rows of the longest column.
    int fill(std::size_t columns);
    /// Makes the page as high as its texts need at their present width.
    void makeRoom();
    void addRow(const QString &group, const QString &text, QWidget *caps);
    Group &groupCalled(const QString &name);

    const Theme &m_theme;
    QWidget *m_page;
    QScrollArea *m_area = nullptr;
    QHBoxLayout *m_row = nullptr;           ///< of the columns
    std::array<QVBoxLayout *, 4> m_columns; ///< each group goes into the shortest of those in use
    std::vector<Group> m_groups;
};

}
