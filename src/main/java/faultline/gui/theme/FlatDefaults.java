package faultline.gui.theme;

import java.awt.Color;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.border.Border;
import javax.swing.border.CompoundBorder;
import javax.swing.border.EmptyBorder;
import javax.swing.border.LineBorder;
import javax.swing.border.MatteBorder;
import javax.swing.plaf.BorderUIResource;
import javax.swing.plaf.InsetsUIResource;

/** The UI defaults that make Metal flat. */
final class FlatDefaults {

    private static final int LIST_ICON_SIZE = 16;
    private static final int DIALOG_ICON_SIZE = 32;

    private final ThemeColours colours;
    private final Map<Object, Object> table = new HashMap<>();

    private FlatDefaults(ThemeColours colours) {
        this.colours = colours;
    }

    static Map<Object, Object> table(ThemeColours colours) {
        FlatDefaults defaults = new FlatDefaults(colours);
        defaults.addDelegates();
        defaults.addButtons();
        defaults.addFields();
        defaults.addMenus();
        defaults.addBars();
        defaults.addContainers();
        defaults.addIcons();
        return defaults.table;
    }

    private void addDelegates() {
        for (String control :
                new String[] {"MenuBar", "ToolBar", "Separator", "PopupMenuSeparator", "ToolBarSeparator"}) {
            table.put(control + "UI", "javax.swing.plaf.basic.Basic" + control + "UI");
        }
    }

    private void addButtons() {
        table.put("Button.border", padding(6, 14, 6, 14));
        table.put("ToggleButton.border", padding(6, 7, 6, 7));
        table.put("Button.rollover", true);
        table.put("Button.defaultButtonFollowsFocus", true);
        table.put("CheckBox.icon", new CheckBoxIcon());
        table.put("CheckBox.background", colours.background());
        table.put("CheckBox.textIconGap", 7);
        table.put("CheckBox.border", padding(2, 2, 2, 2));
    }

    private void addFields() {
        for (String field :
                new String[] {"TextField", "FormattedTextField", "ComboBox", "Spinner", "TextArea", "List", "Table"}) {
            table.put(field + ".background", colours.field());
            table.put(field + ".foreground", colours.text());
            table.put(field + ".inactiveForeground", colours.muted());
        }
        table.put("TextField.border", new BorderUIResource(new FieldBorder(4, 8)));
        table.put("FormattedTextField.border", new BorderUIResource(new FieldBorder(4, 8)));
        table.put("Spinner.border", new BorderUIResource(new FieldBorder(2, 2)));
        table.put("Spinner.editorBorderPainted", false);
        table.put("Spinner.arrowButtonInsets", new InsetsUIResource(2, 0, 2, 2));
        table.put("ComboBox.border", new BorderUIResource(new FieldBorder(2, 2)));
        table.put("ComboBox.disabledForeground", colours.muted());
        table.put("ComboBox.disabledBackground", colours.field());
        table.put("ComboBox.selectionBackground", colours.accent());
        table.put("ComboBox.selectionForeground", colours.onAccent());
        // Arrows in an open list only move in it; Enter chooses.
        table.put("ComboBox.noActionOnKeyNavigation", true);
        table.put("TextField.inactiveBackground", colours.background());
        table.put("List.cellNoFocusBorder", padding(1, 6, 1, 6));
        Border focused =
                new BorderUIResource(new CompoundBorder(new LineBorder(colours.accent()), new EmptyBorder(0, 5, 0, 5)));
        table.put("List.focusCellHighlightBorder", focused);
        // A line in the colour of the selection would not show.
        table.put(
                "List.focusSelectedCellHighlightBorder",
                new BorderUIResource(new CompoundBorder(
                        BorderFactory.createDashedBorder(colours.onAccent()), new EmptyBorder(0, 5, 0, 5))));
    }

    private void addMenus() {
        table.put("MenuBar.border", separatorBorder(0, 1, new EmptyBorder(0, 4, 0, 0)));
        table.put("MenuBar.background", colours.background());
        table.put("Menu.border", padding(4, 8, 4, 8));
        for (String item : new String[] {"MenuItem", "CheckBoxMenuItem", "RadioButtonMenuItem", "Menu"}) {
            table.put(item + ".borderPainted", false);
            table.put(item + ".selectionBackground", item.equals("Menu") ? colours.hover() : colours.accent());
            table.put(item + ".selectionForeground", item.equals("Menu") ? colours.text() : colours.onAccent());
            table.put(item + ".acceleratorForeground", colours.muted());
            table.put(item + ".acceleratorSelectionForeground", colours.onAccent());
            table.put(item + ".acceleratorDelimiter", "+");
            table.put(item + ".checkIconOffset", 2);
            table.put(item + ".afterCheckIconGap", 6);
        }
        for (String item : new String[] {"MenuItem", "CheckBoxMenuItem"}) {
            // As far from the left as a submenu, which is a Menu.
            table.put(item + ".border", padding(4, 8, 4, 12));
        }
        table.put("CheckBoxMenuItem.checkIcon", new CheckBoxIcon());
        table.put(
                "PopupMenu.border",
                new BorderUIResource(new CompoundBorder(new LineBorder(colours.line()), new EmptyBorder(4, 0, 4, 0))));
        table.put("PopupMenu.background", colours.background());
    }

    private void addBars() {
        table.put("ToolBar.border", separatorBorder(0, 1, new EmptyBorder(4, 8, 4, 8)));
        table.put("ToolBar.background", colours.background());
        table.put("Slider.background", colours.background());
        table.put("ScrollBar.width", 12);
        table.put("Separator.foreground", colours.line());
        table.put("Separator.background", colours.background());
        boolean dark = colours == ThemeColours.DARK;
        table.put("ToolTip.background", dark ? colours.pressed() : colours.text());
        table.put("ToolTip.foreground", dark ? colours.text() : colours.field());
        table.put("ToolTip.border", padding(4, 8, 4, 8));
    }

    private void addContainers() {
        table.put("Panel.background", colours.background());
        table.put("Viewport.background", colours.background());
        table.put("ScrollPane.border", new BorderUIResource(new FocusRing.FocusBorder(true)));
        table.put("Table.gridColor", colours.line());
        table.put("Table.rowHeight", 26);
        table.put("TableHeader.background", colours.background());
        table.put("TableHeader.cellBorder", separatorBorder(0, 1, new EmptyBorder(4, 6, 4, 6)));
        table.put("SplitPane.dividerSize", 7);
        table.put("SplitPane.border", padding(0, 0, 0, 0));
        table.put("SplitPaneDivider.border", padding(0, 0, 0, 0));
        table.put("OptionPane.buttonPadding", 12);
    }

    /** Adds the icons of file choosers and option panes. */
    private void addIcons() {
        table.put("FileView.directoryIcon", small(Glyph.FOLDER));
        table.put("FileView.fileIcon", small(Glyph.FILE));
        table.put("FileView.computerIcon", small(Glyph.DRIVE));
        table.put("FileView.hardDriveIcon", small(Glyph.DRIVE));
        table.put("FileView.floppyDriveIcon", small(Glyph.DRIVE));
        table.put("FileChooser.newFolderIcon", Glyph.NEW_FOLDER.icon());
        table.put("FileChooser.upFolderIcon", Glyph.UP.icon());
        table.put("FileChooser.homeFolderIcon", Glyph.HOME.icon());
        table.put("FileChooser.listViewIcon", Glyph.LIST.icon());
        table.put("FileChooser.detailsViewIcon", Glyph.DETAILS.icon());
        table.put("OptionPane.errorIcon", large(Glyph.WARNING, ThemeColours::warning));
        table.put("OptionPane.warningIcon", large(Glyph.WARNING, ThemeColours::warning));
        table.put("OptionPane.informationIcon", large(Glyph.NOTE, ThemeColours::accent));
        table.put("OptionPane.questionIcon", large(Glyph.QUESTION, ThemeColours::accent));
    }

    private static GlyphIcon small(Glyph glyph) {
        return new GlyphIcon(glyph, LIST_ICON_SIZE, null);
    }

    private static GlyphIcon large(Glyph glyph, Function<ThemeColours, Color> colour) {
        return new GlyphIcon(glyph, DIALOG_ICON_SIZE, colour);
    }

    private Border separatorBorder(int above, int below, Border inner) {
        Color line = colours.line();
        return new BorderUIResource(new CompoundBorder(new MatteBorder(above, 0, below, 0, line), inner));
    }

    private static Border padding(int top, int left, int bottom, int right) {
        return new BorderUIResource(new EmptyBorder(top, left, bottom, right));
    }
}
