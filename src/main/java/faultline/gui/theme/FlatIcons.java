package faultline.gui.theme;

import java.awt.Color;
import java.util.Map;
import java.util.function.Function;

/** The icons of file choosers and option panes. */
final class FlatIcons {

    private static final int LIST_ICON_SIZE = 16;
    private static final int DIALOG_ICON_SIZE = 32;

    private FlatIcons() {}

    static Map<String, GlyphIcon> table() {
        return Map.ofEntries(
                Map.entry("FileView.directoryIcon", small(Glyph.FOLDER)),
                Map.entry("FileView.fileIcon", small(Glyph.FILE)),
                Map.entry("FileView.computerIcon", small(Glyph.DRIVE)),
                Map.entry("FileView.hardDriveIcon", small(Glyph.DRIVE)),
                Map.entry("FileView.floppyDriveIcon", small(Glyph.DRIVE)),
                Map.entry("FileChooser.newFolderIcon", Glyph.NEW_FOLDER.icon()),
                Map.entry("FileChooser.upFolderIcon", Glyph.UP.icon()),
                Map.entry("FileChooser.homeFolderIcon", Glyph.HOME.icon()),
                Map.entry("FileChooser.listViewIcon", Glyph.LIST.icon()),
                Map.entry("FileChooser.detailsViewIcon", Glyph.DETAILS.icon()),
                Map.entry("OptionPane.errorIcon", large(Glyph.WARNING, ThemeColours::warning)),
                Map.entry("OptionPane.warningIcon", large(Glyph.WARNING, ThemeColours::warning)),
                Map.entry("OptionPane.informationIcon", large(Glyph.NOTE, ThemeColours::accent)),
                Map.entry("OptionPane.questionIcon", large(Glyph.QUESTION, ThemeColours::accent)));
    }

    private static GlyphIcon small(Glyph glyph) {
        return new GlyphIcon(glyph, LIST_ICON_SIZE, null);
    }

    private static GlyphIcon large(Glyph glyph, Function<ThemeColours, Color> colour) {
        return new GlyphIcon(glyph, DIALOG_ICON_SIZE, colour);
    }
}
