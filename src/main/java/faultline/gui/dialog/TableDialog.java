package faultline.gui.dialog;

import faultline.gui.action.Keystrokes;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.RowTable;
import faultline.gui.text.Messages;
import faultline.gui.text.TextListener;
import faultline.gui.theme.DialogButtons;
import faultline.gui.theme.EmptyToolTips;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.table.DefaultTableModel;

/**
 * A modal dialog with a heading, a read-only table and a button. Escape and Enter close it. A long table has a field
 * above it that hides the rows without the text that is typed.
 */
final class TableDialog extends JDialog {

    private static final int MAX_TABLE_HEIGHT = 360;
    /** The greatest number of rows without a field to search them. */
    private static final int MAX_UNSEARCHED_ROWS = 15;

    /** A column: its heading and its minimum width, pixels. */
    record DialogColumn(String heading, int minWidth) {}

    /** Creates a dialog that is not yet visible, with a sentence and an icon above a table of texts. */
    TableDialog(
            Window owner,
            String title,
            String heading,
            Icon icon,
            List<DialogColumn> columns,
            List<List<String>> rows) {
        super(owner, title, ModalityType.APPLICATION_MODAL);
        JPanel content = new JPanel(new BorderLayout(0, 12));
        content.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
        JTable table = createTable(columns, rows);
        WrappedCellRenderer cells = WrappedCellRenderer.install(
                table, columns.stream().map(DialogColumn::minWidth).toList());
        JPanel top = createHeading(heading, icon);
        if (rows.size() > MAX_UNSEARCHED_ROWS) {
            top.add(createSearch(rows, table, cells), BorderLayout.SOUTH);
        }
        content.add(top, BorderLayout.NORTH);
        content.add(createScrollPane(table, title), BorderLayout.CENTER);
        content.add(DialogButtons.createSingleButton(this, "dialog.close", this::dispose), BorderLayout.SOUTH);
        setContentPane(content);
        EmptyToolTips.disable(content);
        ScreenFit.pack(this);
        // The height of a heading that wraps is known after its width.
        content.invalidate();
        ScreenFit.pack(this);
        setLocationRelativeTo(owner);
    }

    private static JPanel createHeading(String heading, Icon icon) {
        JTextArea text = UiText.wrappedText(heading);
        JLabel label = new JLabel(icon);
        label.setVerticalAlignment(JLabel.TOP);
        JPanel row = new JPanel(new BorderLayout(12, 12));
        row.add(label, BorderLayout.LINE_START);
        row.add(text, BorderLayout.CENTER);
        return row;
    }

    private static JPanel createSearch(List<List<String>> rows, JTable table, WrappedCellRenderer cells) {
        JTextField search = new JTextField();
        search.getAccessibleContext().setAccessibleName(Messages.get("table.search"));
        search.getDocument().addDocumentListener(new TextListener(() -> {
            show(rowsWith(search.getText(), rows), table);
            cells.fitRows(table);
        }));
        JPanel line = new JPanel(new BorderLayout(8, 0));
        line.add(FormConstraints.label("table.search", search), BorderLayout.LINE_START);
        line.add(search, BorderLayout.CENTER);
        return line;
    }

    /** Returns the rows with a text in one of their cells, in capital or small letters. */
    private static List<List<String>> rowsWith(String text, List<List<String>> rows) {
        String wanted = text.strip().toLowerCase(Locale.ROOT);
        return rows.stream()
                .filter(row -> row.stream()
                        .anyMatch(cell -> cell.toLowerCase(Locale.ROOT).contains(wanted)))
                .toList();
    }

    private static void show(List<List<String>> rows, JTable table) {
        DefaultTableModel model = (DefaultTableModel) table.getModel();
        model.setRowCount(0);
        rows.forEach(row -> model.addRow(row.toArray()));
    }

    private static JTable createTable(List<DialogColumn> columns, List<List<String>> rows) {
        Object[] headings = columns.stream().map(DialogColumn::heading).toArray();
        DefaultTableModel model = new DefaultTableModel(headings, 0) {
            @Override
            public boolean isCellEditable(int row, int column) {
                return false;
            }
        };
        JTable table = new RowTable(model);
        show(rows, table);
        table.getTableHeader().setReorderingAllowed(false);
        // Enter presses the button; otherwise it would select the next row.
        table.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .put(Keystrokes.unmodified(KeyEvent.VK_ENTER), "none");
        return table;
    }

    private static JScrollPane createScrollPane(JTable table, String name) {
        table.getAccessibleContext().setAccessibleName(name);
        JScrollPane scroll = new JScrollPane(table);
        int height = table.getPreferredSize().height + table.getTableHeader().getPreferredSize().height + 4;
        scroll.setPreferredSize(new Dimension(table.getPreferredSize().width + 20, Math.min(MAX_TABLE_HEIGHT, height)));
        return scroll;
    }
}
