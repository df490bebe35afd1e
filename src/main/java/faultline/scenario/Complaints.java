package faultline.scenario;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Gathers all that is wrong with one file, so that it is told at once. */
final class Complaints {

    /** No more than this is told of one file. */
    static final int MOST = 100;

    private final String file;
    private final List<Complaint> list = new ArrayList<>();
    private int more;

    Complaints(String file) {
        this.file = file;
    }

    void add(Node node, String text) {
        add(node.place(), text);
    }

    void add(Place place, String text) {
        Complaint complaint = new Complaint(file, place, text);
        if (list.size() == MOST) {
            more++;
        } else if (!list.contains(complaint)) {
            list.add(complaint);
        }
    }

    boolean isEmpty() {
        return list.isEmpty();
    }

    /** Throws what was gathered, in the file's order; does nothing where nothing was. */
    void throwIfAny() throws ScenarioException {
        if (!list.isEmpty()) {
            throw new ScenarioException(inOrder());
        }
    }

    private List<Complaint> inOrder() {
        List<Complaint> ordered = new ArrayList<>(list);
        ordered.sort(Comparator.comparing(Complaint::place));
        if (more > 0) {
            ordered.add(new Complaint(file, Place.NONE, "and " + more + " more complaints"));
        }
        return ordered;
    }
}
