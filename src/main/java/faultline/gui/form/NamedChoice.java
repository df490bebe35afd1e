package faultline.gui.form;

import java.awt.Component;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.ListCellRenderer;
import javax.swing.plaf.basic.ComboPopup;

/** A combo box of values with names. It shows the present value unless the user is choosing. */
public final class NamedChoice<T> extends JComboBox<T> {

    private final transient NameKeySelection<T> keys;
    private boolean updating;

    /** Creates a choice of the first value; {@code onChange} receives every value that the user chooses. */
    public NamedChoice(T[] values, Function<T, String> name, Consumer<T> onChange) {
        super(values);
        setRenderer(rendererOf(name));
        keys = NameKeySelection.install(this, name);
        addActionListener(event -> {
            if (!updating) {
                onChange.accept(value());
            }
        });
    }

    /** Returns a renderer of values by their names. */
    public static <T> ListCellRenderer<Object> rendererOf(Function<T, String> name) {
        return rendererOf(name, item -> null);
    }

    /** Returns a renderer of values by their names, with tool tips in the list, null for none. */
    public static <T> ListCellRenderer<Object> rendererOf(Function<T, String> name, Function<T, String> tip) {
        return new DefaultListCellRenderer() {
            @Override
            @SuppressWarnings("unchecked")
            public Component getListCellRendererComponent(
                    JList<?> items, Object item, int index, boolean selected, boolean focused) {
                String text = item == null ? "" : name.apply((T) item);
                setToolTipText(item == null ? null : tip.apply((T) item));
                return super.getListCellRendererComponent(items, text, index, selected, focused);
            }
        };
    }

    /** Selects the entry for a letter. In the open list, the letter only highlights it, as an arrow key does. */
    @Override
    public boolean selectWithKeyChar(char key) {
        if (!isPopupVisible() || !(getUI().getAccessibleChild(this, 0) instanceof ComboPopup popup)) {
            return super.selectWithKeyChar(key);
        }
        JList<?> list = popup.getList();
        int found = keys.indexForKey(key, getModel(), list.getSelectedIndex());
        if (found >= 0) {
            list.setSelectedIndex(found);
            list.ensureIndexIsVisible(found);
        }
        return found >= 0;
    }

    /** Returns the chosen value. */
    public T value() {
        return getItemAt(getSelectedIndex());
    }

    /** Shows a value, or nothing if it is null, unless the list is open. */
    public void setValue(T value) {
        if (!Objects.equals(value, getSelectedItem()) && !isPopupVisible()) {
            updating = true;
            setSelectedItem(value);
            updating = false;
        }
    }
}
