package faultline.io;

/** Why a file cannot be written. */
public enum WriteProblem implements Message.Template {
    IS_FOLDER("this is a folder, allowed is a file"),
    CANNOT_WRITE("the file cannot be written there"),
    READ_ONLY("the file may not be written");

    private final String english;

    WriteProblem(String english) {
        this.english = english;
    }

    @Override
    public String key() {
        return "problem." + MessageText.camelCase(name());
    }

    @Override
    public String english() {
        return english;
    }
}
