package faultline.gui.window;

import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.document.Task;
import faultline.gui.text.Reasons;
import faultline.gui.text.Texts;
import faultline.gui.text.Wordings;
import faultline.gui.theme.Glyph;
import faultline.scenario.Complaint;
import faultline.scenario.ScenarioException;
import java.awt.Font;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.Icon;
import javax.swing.ImageIcon;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.UIManager;

/** What the window tells its user in a dialog. */
final class Dialogs {

    private static final List<Integer> COMPLAINT_WIDTHS = List.of(60, 70, 560);
    private static final List<Integer> SHORTCUT_WIDTHS = List.of(150, 420);

    private final Window owner;

    Dialogs(Window owner) {
        this.owner = owner;
    }

    void addTo(UiActions actions) {
        actions.add(UiAction.of("shortcuts", () -> shortcuts(actions).setVisible(true)).on(Keystrokes.plain(KeyEvent.VK_F1)));
        actions.add(UiAction.of("guide", () -> GuideDialog.open(owner)));
        actions.add(UiAction.of("about", this::about));
    }

    /** Brings the dialog of a kind to the front, if one is open. Says whether one is. */
    static boolean isBroughtToFront(Window owner, Class<? extends Window> kind) {
        Optional<Window> open = Stream.of(owner.getOwnedWindows()).filter(kind::isInstance).filter(Window::isShowing).findFirst();
        open.ifPresent(Window::toFront);
        open.ifPresent(Window::requestFocus);
        return open.isPresent();
    }

    /** Says why something asked for was not done. */
    void failed(Task task, Path file, Throwable why) {
        if (why instanceof ScenarioException bad && bad.complaints().stream().anyMatch(complaint -> complaint.place().line() > 0)) {
            badFile(file, bad.complaints()).setVisible(true);
            return;
        }
        String sentence = Texts.text("failed." + task, String.valueOf(file.getFileName()), Reasons.of(why, file));
        JOptionPane.showMessageDialog(owner, Lines.broken(sentence), Texts.text("failed.title"), JOptionPane.ERROR_MESSAGE);
    }

    /** Says of the open file that somebody else has made it unreadable. */
    static String brokenOnDisk(ScenarioException bad) {
        Complaint first = bad.complaints().get(0);
        return Texts.text("broken", Path.of(first.file()).getFileName() + first.place().toString() + ": " + Wordings.text(first.text()));
    }

    private JDialog badFile(Path file, List<Complaint> complaints) {
        List<List<String>> rows = complaints.stream()
                .map(complaint -> List.of(number(complaint.place().line()), number(complaint.place().column()), Wordings.text(complaint.text()))).toList();
        List<String> columns = List.of(Texts.text("badFile.line"), Texts.text("badFile.column"), Texts.text("badFile.what"));
        String heading = Texts.text("badFile.heading", String.valueOf(file.getFileName()));
        return new TableDialog(owner, Texts.text("badFile.title"), heading, UIManager.getIcon("OptionPane.errorIcon"), columns,
                COMPLAINT_WIDTHS, rows);
    }

    private static String number(int number) {
        return number > 0 ? Integer.toString(number) : "–";
    }

    private JDialog shortcuts(UiActions actions) {
        List<List<String>> rows = new ArrayList<>();
        actions.all().forEach(action -> action.stroke()
                .ifPresent(stroke -> rows.add(List.of(Keystrokes.text(stroke), String.valueOf(action.getValue(UiAction.LONG_DESCRIPTION))))));
        for (String hand : Texts.text("shortcuts.canvas").split(";")) {
            rows.add(List.of(hand.split(":")));
        }
        List<String> columns = List.of(Texts.text("shortcuts.key"), Texts.text("shortcuts.what"));
        return new TableDialog(owner, Texts.text("shortcuts.title"), Texts.text("shortcuts.heading"), Glyph.NOTE.icon(), columns,
                SHORTCUT_WIDTHS, rows);
    }

    private void about() {
        String version = Optional.ofNullable(Dialogs.class.getPackage().getImplementationVersion()).orElse("–");
        Icon robot = new ImageIcon(AppIcon.images().get(AppIcon.images().size() - 1));
        JLabel name = new JLabel(Texts.text("about.name", version));
        name.setFont(name.getFont().deriveFont(Font.BOLD));
        Object[] message = {name, " ", Texts.text("about.text", System.getProperty("java.version"))};
        JOptionPane.showMessageDialog(owner, message, Texts.text("about.title"), JOptionPane.INFORMATION_MESSAGE, robot);
    }
}
