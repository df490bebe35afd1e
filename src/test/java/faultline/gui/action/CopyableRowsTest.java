package faultline.gui.action;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import javax.swing.JMenuItem;
import javax.swing.JTable;
import javax.swing.RowSorter.SortKey;
import javax.swing.SortOrder;
import org.junit.jupiter.api.Test;

class CopyableRowsTest {

    private final JTable table = callOnEdt(() -> {
        JTable created = new JTable(
                new Object[][] {{"a", 1, true}, {"b", 2, false}, {"c", 3, true}}, new Object[] {"Id", "Count", "Seen"});
        CopyableRows.install(created);
        return created;
    });

    private JMenuItem item(int index) {
        return (JMenuItem) callOnEdt(() -> CopyableRows.createMenu(table).getComponent(index));
    }

    @Test
    void rowsAreCopiedAsTheyAreShownWithTheHeadings() {
        runOnEdt(() -> {
            table.setAutoCreateRowSorter(true);
            table.getRowSorter().setSortKeys(List.of(new SortKey(0, SortOrder.DESCENDING)));
            table.moveColumn(1, 0);
            table.removeColumn(table.getColumnModel().getColumn(2));
            table.setRowSelectionInterval(0, 0);
            table.addRowSelectionInterval(2, 2);
        });
        assertEquals("Count\tId\n3\tc\n1\ta\n", callOnEdt(() -> CopyableRows.selectedText(table)));
    }

    @Test
    void theMenuSelectsAllRowsAndCopiesSelectedOnes() {
        assertFalse(item(0).isEnabled(), "nothing is selected");
        JMenuItem all = item(1);
        runOnEdt(() -> all.doClick(0));
        assertEquals(3, callOnEdt(table::getSelectedRowCount));
        assertTrue(item(0).isEnabled());
    }

    @Test
    void anEmptyTableOffersNothing() {
        JTable empty = callOnEdt(() -> new JTable(0, 2));
        assertFalse(
                callOnEdt(() -> CopyableRows.createMenu(empty).getComponent(1).isEnabled()));
    }

    @Test
    void aKeySelectsAllRows() {
        runOnEdt(() -> table.getActionMap().get("menu A").actionPerformed(null));
        assertEquals(3, callOnEdt(table::getSelectedRowCount));
    }
}
