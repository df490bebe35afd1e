package faultline.gui.form;

import faultline.gui.theme.KeyBindings;
import java.awt.KeyboardFocusManager;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.IntConsumer;
import javax.accessibility.AccessibleContext;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.table.JTableHeader;
import javax.swing.table.TableModel;

/** A table of rows that are read or opened, not edited. */
public class RowTable extends JTable {

    /** Creates a table of a model, whose cells cannot be edited. */
    public RowTable(TableModel model) {
        super(model);
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setShowVerticalLines(false);
        setFillsViewportHeight(true);
        // Tab moves on to the next component, not to the next cell.
        setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
        alignHeadings();
    }

    @Override
    protected final JTableHeader createDefaultTableHeader() {
        return new NamedHeader(this);
    }

    /** Aligns the headings with the texts below them; another look and feel centres them. */
    public final void alignHeadings() {
        if (getTableHeader().getDefaultRenderer() instanceof JLabel headings) {
            headings.setHorizontalAlignment(SwingConstants.LEADING);
        }
    }

    /** Calls a listener with the index of a row in the view when the row is double-clicked or Enter is pressed. */
    public final void onOpen(IntConsumer listener) {
        addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                if (event.getClickCount() == 2) {
                    open(rowAtPoint(event.getPoint()), listener);
                }
            }
        });
        KeyBindings.bind(this, "ENTER", () -> open(getSelectedRow(), listener));
    }

    private static void open(int row, IntConsumer listener) {
        if (row >= 0) {
            listener.accept(row);
        }
    }

    /** A header that screen readers call by the name of its table. */
    private static final class NamedHeader extends JTableHeader {

        private final JTable named;

        NamedHeader(JTable named) {
            super(named.getColumnModel());
            this.named = named;
        }

        @Override
        public AccessibleContext getAccessibleContext() {
            if (accessibleContext == null) {
                accessibleContext = new AccessibleJTableHeader() {
                    @Override
                    public String getAccessibleName() {
                        return named.getAccessibleContext().getAccessibleName();
                    }
                };
            }
            return accessibleContext;
        }
    }
}
