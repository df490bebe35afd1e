package faultline.gui.dialog;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.gallery.Gallery;
import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.function.Consumer;

/** Shows the gallery of shipped scenarios, which also opens files that are dropped on it. */
public final class ExampleActions {

    private final Window owner;
    private final FileController files;
    private final WindowPreferences preferences;
    private final Consumer<String> note;

    /** Creates the actions of a window; {@code note} shows a sentence to the user. */
    public ExampleActions(Window owner, FileController files, WindowPreferences preferences, Consumer<String> note) {
        this.owner = owner;
        this.files = files;
        this.preferences = preferences;
        this.note = note;
    }

    /** Adds the actions that show the gallery and the tour, which {@code tour} starts. */
    public void addTo(ActionRegistry actions, Runnable tour) {
        actions.add(UiAction.of("tour", tour));
        actions.add(UiAction.of("examples", () -> showGallery(tour))
                .withAccelerator(Keystrokes.menuShiftShortcut(KeyEvent.VK_O)));
    }

    /** Shows the gallery in front of the window until the user closes it or drops a file on it. */
    public void showGallery(Runnable tour) {
        Gallery gallery = new Gallery(
                owner,
                files::openShipped,
                preferences.get(Preference.GALLERY_SHOWN),
                shown -> preferences.set(Preference.GALLERY_SHOWN, shown),
                tour);
        gallery.setTransferHandler(files.createDropHandler(gallery::dispose, note));
        TextDropHandler.install(gallery.getContentPane(), gallery.getTransferHandler());
        gallery.setVisible(true);
    }
}
