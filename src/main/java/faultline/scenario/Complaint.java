package faultline.scenario;

/**
 * One thing that is wrong with a file, in one line.
 *
 * @param file as the user named it
 * @param place where in the file, {@link Place#NONE} where it is the whole file
 * @param text what is wrong, the value given, what is allowed
 */
public record Complaint(String file, Place place, String text) {

    /**
     * The line for a user.
     *
     * @return {@code file:line:column: what}, or {@code file: what} without a place
     */
    @Override
    public String toString() {
        return Quoting.oneLine(file) + place + ": " + text;
    }
}
