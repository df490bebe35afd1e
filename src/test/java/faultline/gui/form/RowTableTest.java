package faultline.gui.form;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import javax.swing.table.DefaultTableModel;
import org.junit.jupiter.api.Test;

class RowTableTest {

    @Test
    void theHeaderHasTheNameOfTheTable() {
        assertEquals("Keys", callOnEdt(() -> {
            RowTable table = new RowTable(new DefaultTableModel(new Object[] {"Action", "Key"}, 1));
            table.getAccessibleContext().setAccessibleName("Keys");
            return table.getTableHeader().getAccessibleContext().getAccessibleName();
        }));
    }
}
