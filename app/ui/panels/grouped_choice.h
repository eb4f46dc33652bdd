#pragma once

#include <QComboBox>
#include <QStringList>

class QMenu;

namespace app {

/// A choice among many, by kind: it opens as a menu with a submenu for each kind. Closed, it is like any other: arrow keys
/// go to the next and the previous one.
class GroupedChoice : public QComboBox
{
    Q_OBJECT

public:
    /// `titles`: one an item, with its group; see lessons::grouped(). The items themselves are added as to any choice.
    explicit GroupedChoice(const QStringList &titles, QWidget *parent = nullptr);

    void showPopup() override;

private:
    /// Adds the items of one kind, from number `first` on. Returns the number after the last.
    int addGroup(QMenu &menu, int first);

    QStringList m_groups; ///< one an item
};

}
