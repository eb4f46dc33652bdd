#pragma once

#include <QComboBox>
#include <QStringList>

class QMenu;

namespace app {

/// A combo box with many items in groups. It opens as a menu with a submenu for each group. Closed, it acts
/// like any combo box: the arrow keys choose the next or the previous item.
class GroupedChoice : public QComboBox
{
    Q_OBJECT

public:
    /// `titles` has one title per item, with its group; see lessons::grouped(). The items themselves are
    /// added as in any combo box.
    explicit GroupedChoice(const QStringList &titles, QWidget *parent = nullptr);

    void showPopup() override;

private:
    /// Adds the items of one group, starting at index `first`. Returns the index after the last.
    int addGroup(QMenu &menu, int first);

    QStringList m_groups; ///< one per item
};

}
