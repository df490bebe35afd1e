package faultline.gui.action;

import faultline.gui.theme.KeyBindings;
import faultline.gui.theme.UiText;
import java.awt.Rectangle;
import java.awt.datatransfer.StringSelection;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.UIManager;

/**
 * Copies selected rows of a table, with the headings, as text that spreadsheets read. Several rows can be selected, by
 * keys and in a context menu all of them.
 */
public final class CopyableRows {

    private CopyableRows() {}

    /** Lets rows of a table be copied. */
    public static void install(JTable table) {
        table.setSelectionMode(ListSelectionModel.MULTIPLE_INTERVAL_SELECTION);
        KeyBindings.bind(table, "menu C", () -> copy(table));
        KeyBindings.bind(table, "menu A", table::selectAll);
        table.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                showMenu(table, event);
            }

            @Override
            public void mouseReleased(MouseEvent event) {
                showMenu(table, event);
            }
        });
        for (String key : List.of("shift F10", "CONTEXT_MENU")) {
            KeyBindings.bind(table, key, () -> showMenu(table));
        }
    }

    private static void showMenu(JTable table, MouseEvent event) {
        if (event.isPopupTrigger()) {
            int row = table.rowAtPoint(event.getPoint());
            if (row >= 0 && !table.isRowSelected(row)) {
                table.setRowSelectionInterval(row, row);
            }
            ContextMenu.show(createMenu(table), table, event.getX(), event.getY());
        }
    }

    private static void showMenu(JTable table) {
        Rectangle row = table.getCellRect(Math.max(0, table.getSelectedRow()), 0, true);
        ContextMenu.show(createMenu(table), table, row.x, row.y + row.height);
    }

    /** Creates the context menu of a table whose rows can be copied. */
    static JPopupMenu createMenu(JTable table) {
        JMenuItem copy = UiText.menuText(new JMenuItem(), "table.menu.copy");
        copy.setEnabled(table.getSelectedRow() >= 0);
        copy.addActionListener(event -> copy(table));
        JMenuItem all = UiText.menuText(new JMenuItem(), "table.menu.selectAll");
        all.setEnabled(table.getRowCount() > 0);
        all.addActionListener(event -> table.selectAll());
        JPopupMenu menu = new JPopupMenu();
        menu.add(copy);
        menu.add(all);
        return menu;
    }

    private static void copy(JTable table) {
        if (table.getSelectedRow() < 0) {
            return;
        }
        try {
            table.getToolkit().getSystemClipboard().setContents(new StringSelection(selectedText(table)), null);
        } catch (IllegalStateException busy) {
            // Another program is using the clipboard.
            UIManager.getLookAndFeel().provideErrorFeedback(table);
        }
    }

    /** Returns the headings and the selected rows of a table as they are shown, with tabs between the columns. */
    static String selectedText(JTable table) {
        return Stream.concat(
                        Stream.of(line(table, table::getColumnName)),
                        IntStream.of(table.getSelectedRows())
                                .mapToObj(row -> line(table, column -> String.valueOf(table.getValueAt(row, column)))))
                .collect(Collectors.joining("\n", "", "\n"));
    }

    private static String line(JTable table, IntFunction<String> cell) {
        return IntStream.range(0, table.getColumnCount()).mapToObj(cell).collect(Collectors.joining("\t"));
    }
}
