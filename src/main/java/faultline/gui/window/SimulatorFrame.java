package faultline.gui.window;

import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.Autosave;
import faultline.gui.document.Bench;
import faultline.gui.document.BenchListener;
import faultline.gui.document.FileWatch;
import faultline.gui.document.GhostDesk;
import faultline.gui.document.Recovery;
import faultline.gui.document.Rescuer;
import faultline.gui.document.RunDesk;
import faultline.gui.document.Task;
import faultline.gui.edit.EditDesk;
import faultline.gui.export.ExportDesk;
import faultline.gui.gallery.Gallery;
import faultline.gui.text.Texts;
import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.BoundedRangeModel;
import javax.swing.DefaultBoundedRangeModel;
import javax.swing.JFrame;
import javax.swing.JPopupMenu;
import javax.swing.Timer;
import javax.swing.WindowConstants;

/** The window. A timer asks the bench for the newest frame some sixty times a second; nothing is pushed at it. */
public final class SimulatorFrame extends JFrame {

    private static final int POLL_MILLIS = 16;

    private final transient Bench bench = new Bench(new Events());
    private final transient RunDesk run = new RunDesk(bench);
    private final transient EditDesk edits = new EditDesk(run::send, this::showEdits);
    private final transient EditActions editActions = new EditActions(edits);
    private final transient UiActions actions = new UiActions();
    private final transient Dialogs dialogs = new Dialogs(this);
    private final transient FileDesk files = new FileDesk(this, bench, this::settle);
    private final SimulationCanvas canvas = new SimulationCanvas(edits);
    private final transient ExportDesk exports = new ExportDesk(this, bench, canvas, files::fileFor, file -> noteSaved("saved", file));
    private final transient RunActions runActions;
    private final transient WindowMemory memory;
    private final WorkArea area;
    private final transient WindowPlace place;
    private final transient GhostActions ghosts;
    private final transient FileWatch watch;
    private final transient Waiting waiting = new Waiting(this, bench::cancel);
    private final transient ReplayNotes replay = new ReplayNotes(run.travel(), this::note);
    private final Timer poll = new Timer(POLL_MILLIS, event -> poll());

    /**
     * A window without a scenario, not yet shown.
     *
     * @param memory where it was, and keeps where it is
     */
    public SimulatorFrame(WindowMemory memory) {
        assert EventQueue.isDispatchThread();
        this.memory = memory;
        BoundedRangeModel speed = new DefaultBoundedRangeModel(SpeedScale.REAL_TIME, 0, 0, SpeedScale.MOST);
        runActions = new RunActions(run, speed);
        addActions();
        area = new WorkArea(canvas, edits, actions, speed, run.travel()::goTo);
        ghosts = new GhostActions(new GhostDesk(bench, run.travel()), area);
        ghosts.addTo(actions, files::fileForGhost);
        setJMenuBar(Menus.of(actions));
        getJMenuBar().getMenu(0).insert(new RecentMenu(memory.recent(), files::open), 1);
        setContentPane(area);
        setIconImages(AppIcon.images());
        setTransferHandler(new FileDrop(files::open));
        setTitle(files.title());
        place = new WindowPlace(this, area, memory);
        place.restore();
        closeWithQuestion();
        edit();
        watch = new FileWatch(bench, files::changedOnDisk, bad -> note(Dialogs.brokenOnDisk(bad)));
        edits.tell(new EditNotes(run, actions, this::note));
        poll.start();
    }

    private void addActions() {
        files.addTo(actions, this::quit);
        actions.add(UiAction.of("examples", this::showExamples).on(Keystrokes.menuShift(KeyEvent.VK_O)));
        editActions.addTo(actions);
        editActions.bindTo(getRootPane());
        new ObstacleActions(canvas.tools(), edits, this::note, now -> WaySpeed.ask(this, now), memory).addTo(actions);
        new SensorActions(bench, run, edits).addTo(actions);
        exports.actions().forEach(actions::add);
        ViewActions.addTo(actions, canvas);
        ViewActions.bindTo(getRootPane(), actions);
        actions.add(UiAction.toggle("instruments", memory.isDockShown(), this::showDock).on(Keystrokes.plain(KeyEvent.VK_I)));
        runActions.addTo(actions, this::toggleSensor);
        dialogs.addTo(actions);
        new ChoiceActions(this, memory).addTo(actions);
        actions.add(new ThemeSwitch(this, canvas, memory).action());
    }

    private boolean settle() {
        return area.panel().settle();
    }

    private void note(String sentence) {
        area.status().showNote(sentence);
    }

    private void noteSaved(String key, Path file) {
        note(Texts.text(key, String.valueOf(file.getFileName())));
    }

    /** What the canvas asks for. */
    private void edit() {
        JPopupMenu popup = Menus.onCanvas(actions);
        canvas.tools().addMenuListener(at -> popup.show(canvas, at.x, at.y));
        canvas.tools().addStartListener(pose -> bench.scenario().ifPresent(open -> {
            edits.add(new StartEdit(open.setup().start(), pose, run::startAt));
            run.startAt(pose);
        }));
    }

    private void showEdits() {
        editActions.show();
    }

    private void showDock(boolean shown) {
        area.setDockShown(shown);
    }

    private void toggleSensor(int index) {
        area.panel().toggleSensor(index);
    }

    private void closeWithQuestion() {
        setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                quit();
            }

            @Override
            public void windowOpened(WindowEvent event) {
                place.opened();
                canvas.requestFocusInWindow();
            }
        });
    }

    private void quit() {
        files.unlessLost(() -> {
            place.keep();
            dispose();
        });
    }

    /** Ends the run with the window. */
    @Override
    public void dispose() {
        poll.stop();
        watch.close();
        bench.close();
        super.dispose();
    }

    /**
     * Opens a scenario file, soon.
     *
     * @param file the file
     */
    public void open(Path file) {
        files.openAtOnce(file);
    }

    /**
     * Opens a scenario that ships with the program, soon.
     *
     * @param name its file's name
     */
    public void openShipped(String name) {
        files.openShippedAtOnce(name);
    }

    /**
     * Tells once that a frame has been painted.
     *
     * @param listener told on the event dispatch thread
     */
    public void whenPainted(Runnable listener) {
        canvas.whenPainted(listener);
    }

    /** Shows the examples that ship with the program, in front of the window. */
    public void showExamples() {
        if (!Dialogs.isBroughtToFront(this, Gallery.class)) {
            new Gallery(this, files::openShipped, memory.galleryAtStart(), memory::keepGalleryAtStart).setVisible(true);
        }
    }

    /**
     * Keeps unsaved edits from now on where a crash cannot reach them, and offers those that an earlier crash has left, soon.
     *
     * @param recovery where
     * @param otherwise done where no crash has left any
     */
    public void recover(Recovery recovery, Runnable otherwise) {
        Autosave autosave = new Autosave(bench, recovery);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                autosave.close();
            }
        });
        Rescuer.start(recovery, files::offer, otherwise);
    }

    private void poll() {
        waiting.show(bench.underWay());
        // In this order: where the status says that time is held, the frame is the one that it is held at.
        run.status().ifPresent(status -> run.frame().ifPresent(frame -> {
            area.show(frame, status);
            edits.passed(frame.world().tick());
            replay.show(frame);
            ghosts.show(frame);
            bench.scenario().ifPresent(open -> area.time().show(frame, run.travel().furthest(), open.setup().dt()));
            runActions.show(status);
        }));
    }

    /** What the bench tells. */
    private final class Events implements BenchListener {
        @Override
        public void opened() {
            edits.forget();
            exports.opened();
            bench.file().ifPresent(memory.recent()::add);
        }

        @Override
        public void restarted() {
            edits.restarted();
        }

        @Override
        public void travelled(long tick) {
            edits.travelled(tick);
        }

        @Override
        public void saved(Path file, boolean whole) {
            edits.seal();
            memory.recent().add(file);
            noteSaved(whole ? "saved" : "saved.inPart", file);
        }

        @Override
        public void journalSaved(Path file) {
            noteSaved("saved", file);
        }

        @Override
        public void begun() {
            area.status().reset();
            replay.begun();
        }

        @Override
        public void renamed() {
            setTitle(files.title());
        }

        @Override
        public void failed(Task what, Path file, Throwable why) {
            if (what == Task.OPEN && Files.notExists(file)) {
                memory.recent().remove(file);
            }
            dialogs.failed(what, file, why);
        }
    }
}
