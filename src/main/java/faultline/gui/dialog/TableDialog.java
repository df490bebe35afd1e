package faultline.gui.dialog;

import faultline.gui.action.Keystrokes;
import faultline.gui.panel.RowTable;
import faultline.gui.theme.DialogButtons;
import faultline.gui.theme.EmptyToolTips;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.table.DefaultTableModel;

/** A modal dialog with a heading, a read-only table and a button. Escape and Enter close it. */
final class TableDialog extends JDialog {

    private static final int MAX_TABLE_HEIGHT = 360;

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
        content.add(createHeading(heading, icon), BorderLayout.NORTH);
        JTable table = createTable(columns, rows);
        WrappedCellRenderer.install(
                table, columns.stream().map(DialogColumn::minWidth).toList());
        content.add(createScrollPane(table, title), BorderLayout.CENTER);
        content.add(DialogButtons.createSingleButton(this, "dialog.close", this::dispose), BorderLayout.SOUTH);
        setContentPane(content);
        EmptyToolTips.disable(content);
        ScreenFit.pack(this);
        // The height of a heading that wraps is known after its width.
        content.invalidate();
        validate();
        setLocationRelativeTo(owner);
    }

    private static JPanel createHeading(String heading, Icon icon) {
        JTextArea text = UiText.wrappedText(heading);
        JLabel label = new JLabel(icon);
        label.setVerticalAlignment(JLabel.TOP);
        JPanel row = new JPanel(new BorderLayout(12, 0));
        row.add(label, BorderLayout.LINE_START);
        row.add(text, BorderLayout.CENTER);
        return row;
    }

    private static JTable createTable(List<DialogColumn> columns, List<List<String>> rows) {
        Object[] headings = columns.stream().map(DialogColumn::heading).toArray();
        DefaultTableModel model = new DefaultTableModel(headings, 0) {
            @Override
            public boolean isCellEditable(int row, int column) {
                return false;
            }
        };
        rows.forEach(row -> model.addRow(row.toArray()));
        JTable table = new RowTable(model);
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
