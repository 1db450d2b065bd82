<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- Texts of the rooms below the window: src/viewer/language/core_words.h says how they are looked up. -->
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>keys</name>
    <message>
        <source>Left drag, arrows</source>
        <translation>Links ziehen, Pfeile</translation>
    </message>
    <message>
        <source>Walk around the patient</source>
        <translation>Um den Patienten herumgehen</translation>
    </message>
    <message>
        <source>Middle drag, Shift + left drag, Shift + arrows</source>
        <translation>Mitte ziehen, Umschalt + links ziehen, Umschalt + Pfeile</translation>
    </message>
    <message>
        <source>Move sideways</source>
        <translation>Seitwärts verschieben</translation>
    </message>
    <message>
        <source>Wheel, right drag, Ctrl + left drag, + and -</source>
        <translation>Rad, rechts ziehen, Strg + links ziehen, + und -</translation>
    </message>
    <message>
        <source>Closer, farther</source>
        <translation>Näher, weiter weg</translation>
    </message>
    <message>
        <source>Right drag in maximum, minimum, average</source>
        <translation>Rechts ziehen in Maximum, Minimum, Mittelwert</translation>
    </message>
    <message>
        <source>Window: wider to the right, brighter up</source>
        <translation>Fensterung: nach rechts breiter, nach oben heller</translation>
    </message>
    <message>
        <source>Double click in 3D</source>
        <translation>Doppelklick in 3D</translation>
    </message>
    <message>
        <source>Turn around what is there, and show it on slices</source>
        <translation>Um das drehen, was dort ist, und es auf Schichten zeigen</translation>
    </message>
    <message>
        <source>Window of the series again</source>
        <translation>Wieder die Fensterung der Serie</translation>
    </message>
    <message>
        <source>Look from anterior</source>
        <translation>Ansicht von anterior</translation>
    </message>
    <message>
        <source>Look from posterior</source>
        <translation>Ansicht von posterior</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s left</source>
        <translation>Ansicht von links des Patienten</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s right</source>
        <translation>Ansicht von rechts des Patienten</translation>
    </message>
    <message>
        <source>Look from superior</source>
        <translation>Ansicht von superior</translation>
    </message>
    <message>
        <source>Look from inferior</source>
        <translation>Ansicht von inferior</translation>
    </message>
    <message>
        <source>Fit what is visible</source>
        <translation>Sichtbares einpassen</translation>
    </message>
    <message>
        <source>Patient, study and series over the picture, in title and lists, or not</source>
        <translation>Patient, Studie und Serie über dem Bild, in Titel und Listen, oder nicht</translation>
    </message>
    <message>
        <source>Ctrl+1 to Ctrl+6</source>
        <translation>Strg+1 bis Strg+6</translation>
    </message>
    <message>
        <source>Cinematic, clear, ray cast, maximum, minimum, average</source>
        <translation>Cinematic, Klar, Volumen-Rendering, Maximum, Minimum, Mittelwert</translation>
    </message>
    <message>
        <source>Shade the ray cast, or not</source>
        <translation>Volumen-Rendering schattieren, oder nicht</translation>
    </message>
    <message>
        <source>Remove the table of a CT, or show it again</source>
        <translation>Den Tisch eines CT entfernen oder wieder zeigen</translation>
    </message>
    <message>
        <source>No clip</source>
        <translation>Kein Beschnitt</translation>
    </message>
    <message>
        <source>Drop a folder or a file</source>
        <translation>Ordner oder Datei ablegen</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Open an image or a volume file</source>
        <translation>Bild oder Volumendatei öffnen</translation>
    </message>
    <message>
        <source>Save the view: all that was chosen, and the camera</source>
        <translation>Ansicht speichern: alles, was gewählt wurde, und die Kamera</translation>
    </message>
    <message>
        <source>Open a view that was saved</source>
        <translation>Gespeicherte Ansicht öffnen</translation>
    </message>
    <message>
        <source>Save the picture, at any size</source>
        <translation>Bild speichern, in jeder Größe</translation>
    </message>
    <message>
        <source>Save the measurements as a table</source>
        <translation>Messungen als Tabelle speichern</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Letzte Änderung rückgängig</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>F5 to F9</source>
        <translation>F5 bis F9</translation>
    </message>
    <message>
        <source>Four panes, or 3D, axial, coronal, sagittal alone</source>
        <translation>Vier Bildfelder, oder 3D, axial, koronar, sagittal allein</translation>
    </message>
    <message>
        <source>F2 to F4</source>
        <translation>F2 bis F4</translation>
    </message>
    <message>
        <source>Panels: studies, transfer function, clip</source>
        <translation>Leisten: Studien, Übertragungsfunktion, Beschnitt</translation>
    </message>
    <message>
        <source>Find a study of the folder</source>
        <translation>Studie des Ordners suchen</translation>
    </message>
    <message>
        <source>F, double right click on slices</source>
        <translation>F, Doppelklick rechts auf Schichten</translation>
    </message>
    <message>
        <source>The whole slice, in the middle of its pane</source>
        <translation>Die ganze Schicht, in der Mitte ihres Bildfelds</translation>
    </message>
    <message>
        <source>Tab, Shift + Tab</source>
        <translation>Tab, Umschalt + Tab</translation>
    </message>
    <message>
        <source>To the next pane or control, or back</source>
        <translation>Zum nächsten Bildfeld oder Bedienelement, oder zurück</translation>
    </message>
    <message>
        <source>Wheel, Up, Down on slices</source>
        <translation>Rad, Auf, Ab auf Schichten</translation>
    </message>
    <message>
        <source>Next slice; with Shift, or Page Up and Page Down, five; Home and End: to the ends</source>
        <translation>Nächste Schicht; mit Umschalt oder Bild auf und Bild ab fünf; Pos1 und Ende: zu den Enden</translation>
    </message>
    <message>
        <source>Right drag, 1 to 9 on slices</source>
        <translation>Rechts ziehen, 1 bis 9 auf Schichten</translation>
    </message>
    <message>
        <source>Window: wider to the right, brighter up; or a customary one</source>
        <translation>Fensterung: nach rechts breiter, nach oben heller; oder eine übliche</translation>
    </message>
    <message>
        <source>Ctrl + wheel, middle drag, +, - on slices</source>
        <translation>Strg + Rad, Mitte ziehen, +, - auf Schichten</translation>
    </message>
    <message>
        <source>Closer, sideways</source>
        <translation>Näher, seitwärts</translation>
    </message>
    <message>
        <source>C, W, Z, M, D, G, E, V</source>
        <translation>C, W, Z, M, D, G, E, V</translation>
    </message>
    <message>
        <source>Left button on slices: cross-hair, window, zoom, move, distance, angle, ellipse, probe</source>
        <translation>Linke Taste auf Schichten: Fadenkreuz, Fensterung, Zoom, Verschieben, Strecke, Winkel, Ellipse, Messpunkt</translation>
    </message>
    <message>
        <source>I on slices</source>
        <translation>I auf Schichten</translation>
    </message>
    <message>
        <source>White and black change places</source>
        <translation>Weiß und Schwarz tauschen den Platz</translation>
    </message>
    <message>
        <source>Space on slices</source>
        <translation>Leertaste auf Schichten</translation>
    </message>
    <message>
        <source>Play through all slices, or stop</source>
        <translation>Alle Schichten abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Delete on slices</source>
        <translation>Entf auf Schichten</translation>
    </message>
    <message>
        <source>Remove the measurement that is chosen</source>
        <translation>Die gewählte Messung entfernen</translation>
    </message>
    <message>
        <source>Double click on slices</source>
        <translation>Doppelklick auf Schichten</translation>
    </message>
    <message>
        <source>This pane alone, or all four</source>
        <translation>Dieses Bildfeld allein, oder alle vier</translation>
    </message>
    <message>
        <source>Settings: language, look, keys, what is kept</source>
        <translation>Einstellungen: Sprache, Aussehen, Tasten, was aufbewahrt wird</translation>
    </message>
    <message>
        <source>All keys</source>
        <translation>Alle Tasten</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>&amp;Four Panes</source>
        <translation>&amp;Vier Bildfelder</translation>
    </message>
    <message>
        <source>&amp;3D Alone</source>
        <translation>&amp;3D allein</translation>
    </message>
    <message>
        <source>A&amp;xial Alone</source>
        <translation>A&amp;xial allein</translation>
    </message>
    <message>
        <source>C&amp;oronal Alone</source>
        <translation>K&amp;oronar allein</translation>
    </message>
    <message>
        <source>Sa&amp;gittal Alone</source>
        <translation>Sa&amp;gittal allein</translation>
    </message>
    <message>
        <source>Alt + left drag, Ctrl + Left and Right, [ and ]</source>
        <translation>Alt + links ziehen, Strg + Links und Rechts, [ und ]</translation>
    </message>
    <message>
        <source>Turn the picture: clockwise to the right</source>
        <translation>Bild drehen: nach rechts im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Alt + wheel</source>
        <translation>Alt + Rad</translation>
    </message>
    <message>
        <source>Fly in: the camera and what it turns around go forward</source>
        <translation>Hineinfliegen: Kamera und Drehpunkt gehen vorwärts</translation>
    </message>
    <message>
        <source>Alt + right drag, or drag with T held</source>
        <translation>Alt + rechts ziehen, oder ziehen mit gehaltenem T</translation>
    </message>
    <message>
        <source>Transfer function: shift to the right, widen upwards</source>
        <translation>Übertragungsfunktion: nach rechts verschieben, nach oben verbreitern</translation>
    </message>
    <message>
        <source>Parallel rays, or seen by an eye</source>
        <translation>Parallele Strahlen, oder wie mit einem Auge gesehen</translation>
    </message>
    <message>
        <source>Cube and scale, or not</source>
        <translation>Würfel und Maßstab, oder nicht</translation>
    </message>
    <message>
        <source>Click on a side of the cube</source>
        <translation>Klick auf eine Seite des Würfels</translation>
    </message>
    <message>
        <source>Look from there, as near as before</source>
        <translation>Ansicht von dort, so nah wie vorher</translation>
    </message>
    <message>
        <source>Handles of the clip in all pictures, or not</source>
        <translation>Griffe des Beschnitts in allen Bildern, oder nicht</translation>
    </message>
    <message>
        <source>Shift + wheel in 3D with handles</source>
        <translation>Umschalt + Rad in 3D mit Griffen</translation>
    </message>
    <message>
        <source>Cut across the line of sight: deeper, less deep</source>
        <translation>Schnitt quer zur Blickrichtung: tiefer, weniger tief</translation>
    </message>
    <message>
        <source>Scissors: draw around what is to go in 3D; with Shift, what stays; or not</source>
        <translation>Schere: in 3D umfahren, was weg soll; mit Umschalt, was bleibt; oder nicht</translation>
    </message>
    <message>
        <source>Open a prior or another volume beside the study</source>
        <translation>Voraufnahme oder anderes Volumen neben der Studie öffnen</translation>
    </message>
    <message>
        <source>The second volume in the place of the study, and back</source>
        <translation>Das zweite Volumen an Stelle der Studie, und zurück</translation>
    </message>
    <message>
        <source>Ctrl+Tab</source>
        <translation>Strg+Tab</translation>
    </message>
    <message>
        <source>Save the 3D view as a DICOM presentation state</source>
        <translation>3D-Ansicht als DICOM Presentation State speichern</translation>
    </message>
    <message>
        <source>F2 to F4, F10, F12</source>
        <translation>F2 bis F4, F10, F12</translation>
    </message>
    <message>
        <source>Panels: studies, transfer function, clip; presets; lights</source>
        <translation>Leisten: Studien, Übertragungsfunktion, Beschnitt; Voreinstellungen; Lichter</translation>
    </message>
    <message>
        <source>Drag a handle, Shift + wheel in 3D with the panel of lights</source>
        <translation>Griff ziehen, Umschalt + Mausrad in 3D mit der Leiste der Lichter</translation>
    </message>
    <message>
        <source>Where a light shines from, how strong it is</source>
        <translation>Woher ein Licht scheint, wie stark es ist</translation>
    </message>
    <message>
        <source>There is no such light.</source>
        <translation>Dieses Licht gibt es nicht.</translation>
    </message>
    <message>
        <source>Choose another one of the rig.</source>
        <translation>Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>Without any light the picture would be black.</source>
        <translation>Ohne jedes Licht wäre das Bild schwarz.</translation>
    </message>
    <message>
        <source>Leave a light, or a sky that is not black.</source>
        <translation>Lassen Sie ein Licht oder einen Himmel, der nicht schwarz ist.</translation>
    </message>
    <message>
        <source>The rig has no room for one more light.</source>
        <translation>Für ein weiteres Licht ist kein Platz.</translation>
    </message>
    <message>
        <source>Remove one first.</source>
        <translation>Entfernen Sie zuerst eines.</translation>
    </message>
    <message>
        <source>Panel: segmentations</source>
        <translation>Leiste: Segmentierungen</translation>
    </message>
    <message>
        <source>Ctrl+[ and Ctrl+]</source>
        <translation>Strg+[ und Strg+]</translation>
    </message>
    <message>
        <source>Frames in motion: faster, or more accurate</source>
        <translation>Bilder in Bewegung: schneller, oder genauer</translation>
    </message>
    <message>
        <source>Trace the picture at rest until it is final; Esc stops</source>
        <translation>Das ruhende Bild verfolgen, bis es endgültig ist; Esc hält an</translation>
    </message>
    <message>
        <source>Right click, Menu on slices</source>
        <translation>Rechtsklick, Menütaste auf Schichten</translation>
    </message>
    <message>
        <source>Windows, and those of your own</source>
        <translation>Fensterungen, auch eigene</translation>
    </message>
    <message>
        <source>Alt+1 to Alt+9 on slices</source>
        <translation>Alt+1 bis Alt+9 auf Schichten</translation>
    </message>
    <message>
        <source>A window of your own</source>
        <translation>Eine eigene Fensterung</translation>
    </message>
    <message>
        <source>Double click on a measurement, Enter</source>
        <translation>Doppelklick auf eine Messung, Eingabe</translation>
    </message>
    <message>
        <source>Its label</source>
        <translation>Ihre Beschriftung</translation>
    </message>
</context>
<context>
    <name>titles</name>
    <message>
        <source>Cinematic</source>
        <translation>Cinematic</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Klar</translation>
    </message>
    <message>
        <source>Ray cast</source>
        <translation>Volumen-Rendering</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>Maximum (MIP)</translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation>Minimum (MinIP)</translation>
    </message>
    <message>
        <source>Average (X-ray)</source>
        <translation>Mittelwert (Röntgen)</translation>
    </message>
    <message>
        <source>Cinematic MR</source>
        <translation>Cinematic MR</translation>
    </message>
    <message>
        <source>Cinematic PET</source>
        <translation>Cinematic PET</translation>
    </message>
    <message>
        <source>Cinematic airways</source>
        <translation>Cinematic Atemwege</translation>
    </message>
    <message>
        <source>Cinematic aorta</source>
        <translation>Cinematic Aorta</translation>
    </message>
    <message>
        <source>Cinematic bronchi</source>
        <translation>Cinematic Bronchien</translation>
    </message>
    <message>
        <source>Cinematic fat</source>
        <translation>Cinematic Fett</translation>
    </message>
    <message>
        <source>Cinematic heart</source>
        <translation>Cinematic Herz</translation>
    </message>
    <message>
        <source>Cinematic metal</source>
        <translation>Cinematic Metall</translation>
    </message>
    <message>
        <source>Cinematic MR brain</source>
        <translation>Cinematic MR Gehirn</translation>
    </message>
    <message>
        <source>Cinematic MR skin</source>
        <translation>Cinematic MR Haut</translation>
    </message>
    <message>
        <source>Cinematic muscle</source>
        <translation>Cinematic Muskulatur</translation>
    </message>
    <message>
        <source>Cinematic skeleton</source>
        <translation>Cinematic Skelett</translation>
    </message>
    <message>
        <source>Cinematic skin</source>
        <translation>Cinematic Haut</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Surface gradient</source>
        <translation>Gradient der Oberfläche</translation>
    </message>
    <message>
        <source>Steep gradient</source>
        <translation>Gradient des Steilen</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Reflectance</source>
        <translation>Reflexionsgrad</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation>Anisotropie</translation>
    </message>
    <message>
        <source>Part of the light that the steepest boundary scatters like a rough, wet surface</source>
        <translation>Teil des Lichts, den die steilste Grenze wie eine raue, nasse Oberfläche streut</translation>
    </message>
    <message>
        <source>Steepness of a boundary that is half a surface, in values per mm</source>
        <translation>Steilheit einer Grenze, die halb Oberfläche ist, in Werten je mm</translation>
    </message>
    <message>
        <source>Of presets with curves for steep matter: where half of the matter is steep, in values per mm</source>
        <translation>Bei Voreinstellungen mit Kurven für steile Materie: ab wo die Hälfte der Materie steil ist, in Werten je mm</translation>
    </message>
    <message>
        <source>Of surfaces: highlights are smaller and brighter where it is less</source>
        <translation>Von Oberflächen: Je kleiner, desto kleiner und heller sind Glanzlichter</translation>
    </message>
    <message>
        <source>Of surfaces: the part that they reflect of light which falls straight</source>
        <translation>Von Oberflächen: der Teil senkrecht einfallenden Lichts, den sie spiegeln</translation>
    </message>
    <message>
        <source>Of what scatters like a cloud: above 0 light goes on forwards, below 0 it comes back</source>
        <translation>Von dem, was wie eine Wolke streut: Über 0 läuft Licht nach vorn weiter, unter 0 kommt es zurück</translation>
    </message>
    <message>
        <source>Cinematic bone</source>
        <translation>Cinematic Knochen</translation>
    </message>
    <message>
        <source>Cinematic chest</source>
        <translation>Cinematic Thorax</translation>
    </message>
    <message>
        <source>Cinematic lung</source>
        <translation>Cinematic Lunge</translation>
    </message>
    <message>
        <source>Cinematic soft tissue</source>
        <translation>Cinematic Weichteile</translation>
    </message>
    <message>
        <source>Cinematic vessels</source>
        <translation>Cinematic Gefäße</translation>
    </message>
    <message>
        <source>Cinematic abdomen</source>
        <translation>Cinematic Abdomen</translation>
    </message>
    <message>
        <source>Cinematic colon</source>
        <translation>Cinematic Kolon</translation>
    </message>
    <message>
        <source>Cinematic coronary arteries</source>
        <translation>Cinematic Koronararterien</translation>
    </message>
    <message>
        <source>Cinematic head</source>
        <translation>Cinematic Kopf</translation>
    </message>
    <message>
        <source>Cinematic kidneys</source>
        <translation>Cinematic Nieren</translation>
    </message>
    <message>
        <source>Cinematic liver</source>
        <translation>Cinematic Leber</translation>
    </message>
    <message>
        <source>Cinematic micro-CT</source>
        <translation>Cinematic Mikro-CT</translation>
    </message>
    <message>
        <source>Cinematic MR knee</source>
        <translation>Cinematic MR Knie</translation>
    </message>
    <message>
        <source>Cinematic MR vessels</source>
        <translation>Cinematic MR Gefäße</translation>
    </message>
    <message>
        <source>Cinematic teeth</source>
        <translation>Cinematic Zähne</translation>
    </message>
    <message>
        <source>Cinematic tendons</source>
        <translation>Cinematic Sehnen</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Headlight</source>
        <translation>Stirnlicht</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>Gegenlicht</translation>
    </message>
    <message>
        <source>Theatre</source>
        <translation>Operationssaal</translation>
    </message>
    <message>
        <source>Daylight</source>
        <translation>Tageslicht</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Only a ball in the middle</source>
        <translation>Nur eine Kugel in der Mitte</translation>
    </message>
    <message>
        <source>Only an axial slab through the middle, a tenth of the height</source>
        <translation>Nur ein axialer Slab durch die Mitte, ein Zehntel der Höhe</translation>
    </message>
    <message>
        <source>Left upper front eighth taken out, with the slices on the cuts</source>
        <translation>Linkes oberes vorderes Achtel herausgenommen, mit den Schichten auf den Schnitten</translation>
    </message>
    <message>
        <source>Left upper front eighth taken out, with the slices on the cuts, air black</source>
        <translation>Linkes oberes vorderes Achtel herausgenommen, mit den Schichten auf den Schnitten, Luft schwarz</translation>
    </message>
    <message>
        <source>Opened from the front, with the slice on the cut</source>
        <translation>Von vorn geöffnet, mit der Schicht auf dem Schnitt</translation>
    </message>
    <message>
        <source>Opened from the front, with the slice on the cut, air black</source>
        <translation>Von vorn geöffnet, mit der Schicht auf dem Schnitt, Luft schwarz</translation>
    </message>
    <message>
        <source>Only the back half</source>
        <translation>Nur die hintere Hälfte</translation>
    </message>
    <message>
        <source>Only the front half</source>
        <translation>Nur die vordere Hälfte</translation>
    </message>
    <message>
        <source>Only the lower half</source>
        <translation>Nur die untere Hälfte</translation>
    </message>
    <message>
        <source>Only the patient&apos;s left half</source>
        <translation>Nur die linke Hälfte des Patienten</translation>
    </message>
    <message>
        <source>Only the patient&apos;s right half</source>
        <translation>Nur die rechte Hälfte des Patienten</translation>
    </message>
    <message>
        <source>Only the upper half</source>
        <translation>Nur die obere Hälfte</translation>
    </message>
    <message>
        <source>Own clip</source>
        <translation>Eigener Beschnitt</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>bearbeitet</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Mediastinum</translation>
    </message>
    <message>
        <source>Angiography</source>
        <translation>Angiographie</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>superior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>Presentation state</source>
        <translation>Presentation State</translation>
    </message>
    <message>
        <source>Of the series</source>
        <translation>Der Serie</translation>
    </message>
    <message>
        <source>Usual for PET</source>
        <translation>Üblich für PET</translation>
    </message>
    <message>
        <source>SUV 0 to 5</source>
        <translation>SUV 0 bis 5</translation>
    </message>
    <message>
        <source>SUV 0 to 7</source>
        <translation>SUV 0 bis 7</translation>
    </message>
    <message>
        <source>SUV 0 to 15</source>
        <translation>SUV 0 bis 15</translation>
    </message>
    <message>
        <source>SUV 0 to 20</source>
        <translation>SUV 0 bis 20</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alle Werte</translation>
    </message>
</context>
<context>
    <name>dicom</name>
    <message>
        <source>Copy the whole series again from its source.</source>
        <translation>Kopieren Sie die ganze Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Copy the file again from its source.</source>
        <translation>Kopieren Sie die Datei noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Choose another series.</source>
        <translation>Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>Look at these images by themselves, or copy the series again from its source.</source>
        <translation>Sehen Sie sich diese Bilder einzeln an, oder kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Export the series again, or choose another.</source>
        <translation>Exportieren Sie die Serie noch einmal, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>No file of this series can be read; it has %1.</source>
        <translation>Keine Datei dieser Serie kann gelesen werden; sie hat %1.</translation>
    </message>
    <message>
        <source>A file cannot be opened.</source>
        <translation>Eine Datei kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Check its permissions.</source>
        <translation>Prüfen Sie die Zugriffsrechte.</translation>
    </message>
    <message>
        <source>A file is listed in the folder, and its content is not on this machine.</source>
        <translation>Eine Datei steht im Ordner, aber ihr Inhalt ist nicht auf diesem Rechner.</translation>
    </message>
    <message>
        <source>Connect the drive, or make the files available offline.</source>
        <translation>Verbinden Sie das Laufwerk, oder machen Sie die Dateien offline verfügbar.</translation>
    </message>
    <message>
        <source>The medium gave an error where something was to be read from it: it is damaged, dirty or failing.</source>
        <translation>Das Medium meldete einen Fehler, als etwas gelesen werden sollte: Es ist beschädigt, verschmutzt oder am Versagen.</translation>
    </message>
    <message>
        <source>Clean the disc, or check drive and cable, and copy the medium again; else ask for another copy.</source>
        <translation>Reinigen Sie die Disc, oder prüfen Sie Laufwerk und Kabel, und kopieren Sie das Medium noch einmal; sonst bitten Sie um eine andere Kopie.</translation>
    </message>
    <message>
        <source>A path is longer than this system can open; what lies there is missing here.</source>
        <translation>Ein Pfad ist länger, als dieses System öffnen kann; was dort liegt, fehlt hier.</translation>
    </message>
    <message>
        <source>Move the folder nearer to the root of the disk, or give the folders shorter names.</source>
        <translation>Verschieben Sie den Ordner näher an die Wurzel des Laufwerks, oder geben Sie den Ordnern kürzere Namen.</translation>
    </message>
    <message>
        <source>The path is longer than this system can open.</source>
        <translation>Der Pfad ist länger, als dieses System öffnen kann.</translation>
    </message>
    <message>
        <source>A DICOM file is damaged and cannot be read.</source>
        <translation>Eine DICOM-Datei ist beschädigt und kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>A DICOM file ends before its pixel data do.</source>
        <translation>Eine DICOM-Datei endet vor ihren Pixeldaten.</translation>
    </message>
    <message>
        <source>A DICOM image has no pixel data.</source>
        <translation>Ein DICOM-Bild hat keine Pixeldaten.</translation>
    </message>
    <message>
        <source>A DICOM image does not say in a number how many frames it has.</source>
        <translation>Ein DICOM-Bild sagt nicht mit einer Zahl, wie viele Einzelbilder es hat.</translation>
    </message>
    <message>
        <source>Frames that the files of this series should have, and that are not there: %1 of %2.</source>
        <translation>Einzelbilder, die die Dateien dieser Serie haben sollten und die fehlen: %1 von %2.</translation>
    </message>
    <message>
        <source>Compare values and sizes with those that another program shows; have the images set right.</source>
        <translation>Vergleichen Sie Werte und Größen mit denen, die ein anderes Programm zeigt; lassen Sie die Bilder berichtigen.</translation>
    </message>
    <message>
        <source>Images in which attributes stand twice, with different values: %1 of %2 (%3). Of each the first value is used.</source>
        <translation>Bilder, in denen Attribute zweimal mit verschiedenen Werten stehen: %1 von %2 (%3). Von jedem gilt der erste Wert.</translation>
    </message>
    <message>
        <source>Slices may be missing here; copy the series again from its source.</source>
        <translation>Hier können Schichten fehlen; kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Files that hold more than the number of frames they give (NumberOfFrames): %1. What is beyond is not shown: pixels or descriptions of %2 frames.</source>
        <translation>Dateien, die mehr enthalten, als die Zahl ihrer Einzelbilder (NumberOfFrames) angibt: %1. Was darüber hinausgeht, wird nicht gezeigt: Pixel oder Beschreibungen von %2 Einzelbildern.</translation>
    </message>
    <message>
        <source>Bytes follow the pixel data in some files and are no part of the images, which are whole: up to %1.</source>
        <translation>In manchen Dateien folgen auf die Pixeldaten Bytes, die nicht zu den Bildern gehören; diese sind vollständig: bis zu %1.</translation>
    </message>
    <message>
        <source>Images that do not say by what kind of device they were taken (Modality): %1 of %2; they were taken for %3.</source>
        <translation>Bilder, die nicht sagen, mit was für einem Gerät sie aufgenommen wurden (Modality): %1 von %2; sie gelten als %3.</translation>
    </message>
    <message>
        <source>%1, by their kind of object</source>
        <translation>%1, nach der Art ihrer Objekte</translation>
    </message>
    <message>
        <source>images of an unknown device</source>
        <translation>Bilder eines unbekannten Geräts</translation>
    </message>
    <message>
        <source>what others of the series are</source>
        <translation>das, was andere der Serie sind</translation>
    </message>
    <message>
        <source>Files of this series that do not say what kind of object they are: %1.</source>
        <translation>Dateien dieser Serie, die nicht sagen, was für ein Objekt sie sind: %1.</translation>
    </message>
    <message>
        <source>Check that the series is what it seems to be.</source>
        <translation>Prüfen Sie, ob die Serie ist, was sie zu sein scheint.</translation>
    </message>
    <message>
        <source>Folders that could not be read: %1. Images in them are missing here.</source>
        <translation>Ordner, die nicht gelesen werden konnten: %1. Bilder darin fehlen hier.</translation>
    </message>
    <message>
        <source>Check the permissions of the folders, or copy the study again.</source>
        <translation>Prüfen Sie die Zugriffsrechte der Ordner, oder kopieren Sie die Studie noch einmal.</translation>
    </message>
    <message>
        <source>Links that lead out of the chosen folder, and were not followed: %1.</source>
        <translation>Verknüpfungen, die aus dem gewählten Ordner führen und denen nicht gefolgt wurde: %1.</translation>
    </message>
    <message>
        <source>Choose the folder they lead to, if it is wanted.</source>
        <translation>Wählen Sie den Ordner, zu dem sie führen, wenn er gewünscht ist.</translation>
    </message>
    <message>
        <source>Archives (%1) in the folder, which were not opened: %2.</source>
        <translation>Archive (%1) im Ordner, die nicht geöffnet wurden: %2.</translation>
    </message>
    <message>
        <source>Unpack those that hold images of this study, and open the folder again.</source>
        <translation>Entpacken Sie die, in denen Bilder dieser Studie sind, und öffnen Sie den Ordner noch einmal.</translation>
    </message>
    <message>
        <source>The images say that their study has %1 objects (NumberOfStudyRelatedInstances); %2 of it are here.</source>
        <translation>Die Bilder sagen, dass ihre Studie %1 Objekte hat (NumberOfStudyRelatedInstances); davon sind %2 hier.</translation>
    </message>
    <message>
        <source>Copy the study again from its source if all of it should be here.</source>
        <translation>Kopieren Sie die Studie noch einmal von ihrer Quelle, wenn sie ganz hier sein soll.</translation>
    </message>
    <message>
        <source>Slices that seem to be missing beyond the end towards the %1: %2; %3.</source>
        <translation>Schichten, die jenseits des Endes zu fehlen scheinen (%1): %2; %3.</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorne</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>the image numbers begin at %1</source>
        <translation>die Bildnummern beginnen bei %1</translation>
    </message>
    <message>
        <source>the image numbers leave out %1 to %2</source>
        <translation>die Bildnummern lassen %1 bis %2 aus</translation>
    </message>
    <message>
        <source>the images say that their acquisition has %1 (ImagesInAcquisition)</source>
        <translation>die Bilder sagen, dass ihre Aufnahme %1 hat (ImagesInAcquisition)</translation>
    </message>
    <message>
        <source>the images say that the series has %1 (NumberOfSeriesRelatedInstances)</source>
        <translation>die Bilder sagen, dass die Serie %1 hat (NumberOfSeriesRelatedInstances)</translation>
    </message>
    <message>
        <source>the images say that a volume has %1 slices (NumberOfSlices)</source>
        <translation>die Bilder sagen, dass ein Volumen %1 Schichten hat (NumberOfSlices)</translation>
    </message>
    <message>
        <source>the directory of the medium (DICOMDIR) lists them</source>
        <translation>das Verzeichnis des Mediums (DICOMDIR) führt sie auf</translation>
    </message>
    <message>
        <source>Copy the whole series again from its source; what lies beyond this end is not shown.</source>
        <translation>Kopieren Sie die ganze Serie noch einmal von ihrer Quelle; was jenseits dieses Endes liegt, wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>Images of this series that seem to be missing: %1; %2.</source>
        <translation>Bilder dieser Serie, die zu fehlen scheinen: %1; %2.</translation>
    </message>
    <message>
        <source>Copy the whole series again from its source; the slices may end too early.</source>
        <translation>Kopieren Sie die ganze Serie noch einmal von ihrer Quelle; die Schichten enden vielleicht zu früh.</translation>
    </message>
    <message>
        <source>%1 of this study reaches %2 mm farther towards the %3 than these slices.</source>
        <translation>%1 dieser Studie reicht %2 mm weiter als diese Schichten (%3).</translation>
    </message>
    <message>
        <source>Another series</source>
        <translation>Eine andere Serie</translation>
    </message>
    <message>
        <source>The localizer</source>
        <translation>Der Localizer</translation>
    </message>
    <message>
        <source>If both should cover the same, images are missing here: compare with the source.</source>
        <translation>Sollten beide dasselbe abdecken, fehlen hier Bilder: Vergleichen Sie mit der Quelle.</translation>
    </message>
    <message>
        <source>The images say where they lie in a frame of the transducer, and not in the patient: letters of sides, and left and right, are not those of the patient.</source>
        <translation>Die Bilder sagen, wo sie in einem System des Schallkopfs liegen, und nicht im Patienten: Buchstaben der Seiten, und links und rechts, sind nicht die des Patienten.</translation>
    </message>
    <message>
        <source>Do not tell sides from this volume.</source>
        <translation>Lesen Sie an diesem Volumen keine Seiten ab.</translation>
    </message>
    <message>
        <source>Only the first frame says where it lies; it was taken for granted that the others follow it along the slice normal, at the distance that the file gives.</source>
        <translation>Nur das erste Einzelbild sagt, wo es liegt; es wurde vorausgesetzt, dass die anderen ihm entlang der Schichtnormalen folgen, im Abstand, den die Datei nennt.</translation>
    </message>
    <message>
        <source>If they run the other way, the volume is mirrored: compare with a marker of the side.</source>
        <translation>Laufen sie andersherum, ist das Volumen gespiegelt: Vergleichen Sie mit einer Seitenmarkierung.</translation>
    </message>
    <message>
        <source>%1 is not written as numbers with backslashes between them, and can be read in no way, or in several.</source>
        <translation>%1 ist nicht als Zahlen mit umgekehrten Schrägstrichen dazwischen geschrieben und ist gar nicht oder auf mehrere Arten zu lesen.</translation>
    </message>
    <message>
        <source>Have it set right, or export the series again.</source>
        <translation>Lassen Sie es richtigstellen, oder exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>Images whose position, orientation or pixel spacing has other signs between its numbers, or in them, than it should: %1 of %2. It was read in the only way that there is.</source>
        <translation>Bilder, deren Position, Orientierung oder Pixelabstand andere Zeichen zwischen den Zahlen oder in ihnen hat, als sie sollten: %1 von %2. Es wurde auf die einzige Art gelesen, die es gibt.</translation>
    </message>
    <message>
        <source>Measure a known length before relying on sizes.</source>
        <translation>Messen Sie eine bekannte Länge, bevor Sie sich auf Größen verlassen.</translation>
    </message>
    <message>
        <source>There is no DICOM image here but perhaps in an archive (%1), which is not opened.</source>
        <translation>Hier ist kein DICOM-Bild, höchstens in einem Archiv (%1), das nicht geöffnet wird.</translation>
    </message>
    <message>
        <source>There is the directory of a medium (DICOMDIR) here, and none of the %1 files that it lists.</source>
        <translation>Hier ist das Verzeichnis eines Mediums (DICOMDIR), und keine der %1 Dateien, die es aufführt.</translation>
    </message>
    <message>
        <source>Copy the whole medium, with all of its folders, and open the copy.</source>
        <translation>Kopieren Sie das ganze Medium mit allen Ordnern, und öffnen Sie die Kopie.</translation>
    </message>
    <message>
        <source>The only DICOM file in this folder cannot be read: %1.</source>
        <translation>Die einzige DICOM-Datei in diesem Ordner kann nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>None of the %1 DICOM files in this folder can be read: %2.</source>
        <translation>Keine der %1 DICOM-Dateien in diesem Ordner kann gelesen werden: %2.</translation>
    </message>
    <message>
        <source>Files that the directory of this medium (DICOMDIR) lists and that are not there: %1.</source>
        <translation>Dateien, die das Verzeichnis dieses Mediums (DICOMDIR) aufführt und die fehlen: %1.</translation>
    </message>
    <message>
        <source>Copy the medium again; images may be missing.</source>
        <translation>Kopieren Sie das Medium noch einmal; Bilder können fehlen.</translation>
    </message>
    <message>
        <source>Files that the directory of this medium (DICOMDIR) names outside the chosen folder, and that were not read: %1.</source>
        <translation>Dateien, die das Verzeichnis dieses Mediums (DICOMDIR) außerhalb des gewählten Ordners nennt und die nicht gelesen wurden: %1.</translation>
    </message>
    <message>
        <source>Take care where this medium comes from.</source>
        <translation>Achten Sie darauf, woher dieses Medium kommt.</translation>
    </message>
    <message>
        <source>The directory of this medium (DICOMDIR) cannot be read; the files themselves were read.</source>
        <translation>Das Verzeichnis dieses Mediums (DICOMDIR) kann nicht gelesen werden; die Dateien selbst wurden gelesen.</translation>
    </message>
    <message>
        <source>Files that are copies of others of this series, and were left out: %1.</source>
        <translation>Dateien, die Kopien anderer dieser Serie sind und weggelassen wurden: %1.</translation>
    </message>
    <message>
        <source>Images that have the identifier of another of this series, in a file that differs: %1. Of each the first file is used; the others are in a stack of their own.</source>
        <translation>Bilder mit der Kennung eines anderen dieser Serie in einer abweichenden Datei: %1. Von jedem wird die erste Datei verwendet; die anderen liegen in einem eigenen Stapel.</translation>
    </message>
    <message>
        <source>Compare them before relying on this series.</source>
        <translation>Vergleichen Sie sie, bevor Sie sich auf diese Serie verlassen.</translation>
    </message>
    <message>
        <source>Files of this series that cannot be read, and were left out: %1.</source>
        <translation>Dateien dieser Serie, die nicht gelesen werden können und weggelassen wurden: %1.</translation>
    </message>
    <message>
        <source>Copy the series again from its source.</source>
        <translation>Kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Text of this series does not fit the character set it declares; names may be shown wrongly.</source>
        <translation>Text dieser Serie passt nicht zu ihrem angegebenen Zeichensatz; Namen können falsch gezeigt werden.</translation>
    </message>
    <message>
        <source>The files of this series name different patients or studies, and were split into %1 series.</source>
        <translation>Die Dateien dieser Serie nennen verschiedene Patienten oder Studien und wurden in %1 Serien geteilt.</translation>
    </message>
    <message>
        <source>Check name, ID, birth date and sex of the patient in every part; slices of this patient may lie in another part.</source>
        <translation>Prüfen Sie Name, ID, Geburtsdatum und Geschlecht des Patienten in jedem Teil; Schichten dieses Patienten können in einem anderen Teil liegen.</translation>
    </message>
    <message>
        <source>The images differ in %1, and were separated into %2 stacks.</source>
        <translation>Die Bilder unterscheiden sich in %1 und wurden in %2 Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images have different sizes, and were separated into %1 stacks.</source>
        <translation>Die Bilder haben verschiedene Größen und wurden in %1 Stapel getrennt.</translation>
    </message>
    <message>
        <source>Some images are in colour and others are not; they were separated into %1 stacks.</source>
        <translation>Manche Bilder sind farbig und andere nicht; sie wurden in %1 Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images lie in different orientations, and were separated into %1 stacks.</source>
        <translation>Die Bilder haben verschiedene Ausrichtungen und wurden in %1 Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images do not share one coordinate system, or some have no position; they were separated into %1 stacks.</source>
        <translation>Die Bilder haben kein gemeinsames Koordinatensystem, oder manche haben keine Position; sie wurden in %1 Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images have different pixel spacings, and were separated into %1 stacks.</source>
        <translation>Die Bilder haben verschiedene Pixelabstände und wurden in %1 Stapel getrennt.</translation>
    </message>
    <message>
        <source>Every position was imaged %1 times; each is a volume of its own, told apart by %2.</source>
        <translation>Jede Position wurde %1-mal aufgenommen; jede ist ein eigenes Volumen, unterschieden durch %2.</translation>
    </message>
    <message>
        <source>Every position was imaged %1 times, and only the order of the image numbers tells them apart.</source>
        <translation>Jede Position wurde %1-mal aufgenommen, und nur die Reihenfolge der Bildnummern unterscheidet sie.</translation>
    </message>
    <message>
        <source>Images whose %1 does not say to which phase they belong, and whose number was asked instead: %2.</source>
        <translation>Bilder, deren %1 nicht sagt, zu welcher Phase sie gehören, und deren Nummer stattdessen entschied: %2.</translation>
    </message>
    <message>
        <source>Compare these slices with those beside them before relying on them.</source>
        <translation>Vergleichen Sie diese Schichten mit denen daneben, bevor Sie sich auf sie verlassen.</translation>
    </message>
    <message>
        <source>Images of which nothing says for sure to which acquisition or phase they belong: %1. They are in a stack of their own, and the others lack them.</source>
        <translation>Bilder, von denen nichts sicher sagt, zu welcher Aufnahme oder Phase sie gehören: %1. Sie sind ein eigener Stapel, und den anderen fehlen sie.</translation>
    </message>
    <message>
        <source>Look at these images by themselves; part of the scan may have been repeated.</source>
        <translation>Sehen Sie diese Bilder für sich an; ein Teil der Aufnahme wurde vielleicht wiederholt.</translation>
    </message>
    <message>
        <source>Check that the volumes of this series are what they seem to be.</source>
        <translation>Prüfen Sie, ob die Volumen dieser Serie sind, was sie zu sein scheinen.</translation>
    </message>
    <message>
        <source>Phases that have fewer images than the others: %1 of %2.</source>
        <translation>Phasen, die weniger Bilder haben als die anderen: %1 von %2.</translation>
    </message>
    <message>
        <source>Images that lie at the same position as another: %1 of %2. Nothing in them says which belong together.</source>
        <translation>Bilder an derselben Position wie ein anderes: %1 von %2. Nichts darin sagt, welche zusammengehören.</translation>
    </message>
    <message>
        <source>Which images make a volume? Choose another series, or separate the files of this one by hand.</source>
        <translation>Welche Bilder ergeben ein Volumen? Wählen Sie eine andere Serie, oder trennen Sie die Dateien dieser von Hand.</translation>
    </message>
    <message>
        <source>Positions that were imaged more than once: %1. Of each, the image with the lowest number is in the volume, and the others are in a stack of their own.</source>
        <translation>Positionen, die mehrmals aufgenommen wurden: %1. Von jeder ist das Bild mit der kleinsten Nummer im Volumen, die anderen liegen in einem eigenen Stapel.</translation>
    </message>
    <message>
        <source>Compare the repeated images before relying on these slices.</source>
        <translation>Vergleichen Sie die wiederholten Bilder, bevor Sie sich auf diese Schichten verlassen.</translation>
    </message>
    <message>
        <source>Files of those that make up one image that are not here: %1 of %2.</source>
        <translation>Dateien, die zusammen ein Bild ergeben und hier fehlen: %1 von %2.</translation>
    </message>
    <message>
        <source>Series %1 of this study continues this stack, with the same slice distance.</source>
        <translation>Serie %1 dieser Studie setzt diesen Stapel mit demselben Schichtabstand fort.</translation>
    </message>
    <message>
        <source>Look at both; together they cover more.</source>
        <translation>Sehen Sie beide an; zusammen decken sie mehr ab.</translation>
    </message>
    <message>
        <source>This is a localizer: an overview image, not a slice of a volume.</source>
        <translation>Das ist ein Localizer: ein Übersichtsbild, keine Schicht eines Volumens.</translation>
    </message>
    <message>
        <source>Choose a series of slices.</source>
        <translation>Wählen Sie eine Serie von Schichten.</translation>
    </message>
    <message>
        <source>The slices are %1 even sets, the first two shifted by %2 mm against each other, and nothing else tells them apart; each is a stack of its own.</source>
        <translation>Die Schichten sind %1 gleichmäßige Sätze, die ersten beiden um %2 mm gegeneinander verschoben, und nichts sonst unterscheidet sie; jeder ist ein eigener Stapel.</translation>
    </message>
    <message>
        <source>Look at all of them; they may be several acquisitions.</source>
        <translation>Sehen Sie alle an; es sind vielleicht mehrere Aufnahmen.</translation>
    </message>
    <message>
        <source>The image numbers run %1 times along the patient, and nothing else tells these sets of slices apart; each is a stack of its own.</source>
        <translation>Die Bildnummern laufen %1-mal am Patienten entlang, und nichts sonst unterscheidet diese Sätze von Schichten; jeder ist ein eigener Stapel.</translation>
    </message>
    <message>
        <source>Slices %1 were acquired %2 min before or after those beside them: the patient may have moved, and contrast medium spread.</source>
        <translation>Die Schichten %1 wurden %2 min vor oder nach denen daneben aufgenommen: Der Patient kann sich bewegt und Kontrastmittel sich ausgebreitet haben.</translation>
    </message>
    <message>
        <source>The frames belong to %1 stacks (StackID), which make one even volume together and are shown as one.</source>
        <translation>Die Bilder gehören zu %1 Stapeln (StackID), die zusammen ein gleichmäßiges Volumen ergeben und als eines gezeigt werden.</translation>
    </message>
    <message>
        <source>The slices are turned against each other by up to %1 degrees; they are drawn with the mean orientation, and a voxel is up to %2 mm away from where it is drawn.</source>
        <translation>Die Schichten sind um bis zu %1 Grad gegeneinander gedreht; sie werden mit der mittleren Lage gezeichnet, und ein Voxel liegt bis zu %2 mm neben der Stelle, an der es gezeichnet ist.</translation>
    </message>
    <message>
        <source>Allow for this error when measuring.</source>
        <translation>Rechnen Sie beim Messen mit diesem Fehler.</translation>
    </message>
    <message>
        <source>%1 changes along the slices, first at slice %2; values may step there.</source>
        <translation>%1 ändert sich entlang der Schichten, zuerst bei Schicht %2; dort können Werte springen.</translation>
    </message>
    <message>
        <source>Do not take a step there for a finding.</source>
        <translation>Halten Sie einen Sprung dort nicht für einen Befund.</translation>
    </message>
    <message>
        <source>Every other slice differs from those beside it in the same way: two acquisitions may be mixed in this volume.</source>
        <translation>Jede zweite Schicht weicht in gleicher Weise von ihren Nachbarn ab: in diesem Volumen können zwei Aufnahmen vermischt sein.</translation>
    </message>
    <message>
        <source>Compare the original images, slice by slice, before relying on this volume.</source>
        <translation>Vergleichen Sie die Originalbilder Schicht für Schicht, bevor Sie sich auf dieses Volumen verlassen.</translation>
    </message>
    <message>
        <source>The images lie in %1 blocks, up to %2 mm apart; each is a stack of its own, so what is shown is one of %3.</source>
        <translation>Die Bilder liegen in %1 Blöcken, bis zu %2 mm auseinander; jeder ist ein eigener Stapel, gezeigt wird also einer von %3.</translation>
    </message>
    <message>
        <source>Look at the other blocks too.</source>
        <translation>Sehen Sie auch die anderen Blöcke an.</translation>
    </message>
    <message>
        <source>Every image names a coordinate system (FrameOfReferenceUID) of its own, and together they make an even stack; it was taken for granted that they share one.</source>
        <translation>Jedes Bild nennt ein eigenes Koordinatensystem (FrameOfReferenceUID), und zusammen ergeben sie einen gleichmäßigen Stapel; es wurde angenommen, dass sie eines teilen.</translation>
    </message>
    <message>
        <source>Check that the slices fit each other. The series is not shown together with others.</source>
        <translation>Prüfen Sie, ob die Schichten zueinander passen. Die Serie wird nicht zusammen mit anderen gezeigt.</translation>
    </message>
    <message>
        <source>Images that name no coordinate system (FrameOfReferenceUID): %1 of %2. They continue the stack of the others, and it was taken for granted that they share theirs.</source>
        <translation>Bilder, die kein Koordinatensystem (FrameOfReferenceUID) nennen: %1 von %2. Sie setzen den Stapel der anderen fort, und es wurde angenommen, dass sie deren teilen.</translation>
    </message>
    <message>
        <source>Images that share one identifier (SOPInstanceUID) and lie at different positions: %1. All are kept.</source>
        <translation>Bilder, die eine Kennung (SOPInstanceUID) teilen und an verschiedenen Positionen liegen: %1. Alle bleiben.</translation>
    </message>
    <message>
        <source>Other programs may show only one of them; have the identifiers set right.</source>
        <translation>Andere Programme zeigen vielleicht nur eines davon; lassen Sie die Kennungen berichtigen.</translation>
    </message>
    <message>
        <source>Images that repeat another at the same position, pixel by pixel, and were left out: %1.</source>
        <translation>Bilder, die ein anderes an derselben Position Pixel für Pixel wiederholen und weggelassen wurden: %1.</translation>
    </message>
    <message>
        <source>Nothing is lost; the series was probably sent twice.</source>
        <translation>Nichts ist verloren; die Serie wurde wohl zweimal gesendet.</translation>
    </message>
    <message>
        <source>%1 images have a %2 identifier each and would make one even stack together.</source>
        <translation>%1 Bilder haben je eine eigene Kennung (%2) und ergäben zusammen einen gleichmäßigen Stapel.</translation>
    </message>
    <message>
        <source>Are they one series? Then open the folder with --join.</source>
        <translation>Sind sie eine Serie? Dann öffnen Sie den Ordner mit --join.</translation>
    </message>
    <message>
        <source>%1 images with a %2 identifier each were joined to this series because that was asked for.</source>
        <translation>%1 Bilder mit je einer eigenen Kennung (%2) wurden zu dieser Serie verbunden, weil das verlangt wurde.</translation>
    </message>
    <message>
        <source>Check that all of them are of one patient and one examination.</source>
        <translation>Prüfen Sie, ob alle von einem Patienten und einer Untersuchung sind.</translation>
    </message>
    <message>
        <source>There is only one slice.</source>
        <translation>Es gibt nur eine Schicht.</translation>
    </message>
    <message>
        <source>Choose a series with more slices.</source>
        <translation>Wählen Sie eine Serie mit mehr Schichten.</translation>
    </message>
    <message>
        <source>The images do not say where they lie in the patient.</source>
        <translation>Die Bilder sagen nicht, wo sie im Patienten liegen.</translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say where they lie in the patient.</source>
        <translation>Die Einzelbilder dieses Multiframe-Bildes sagen nicht, wo sie im Patienten liegen.</translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say how they are oriented in the patient.</source>
        <translation>Die Einzelbilder dieses Multiframe-Bildes sagen nicht, wie sie im Patienten ausgerichtet sind.</translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say how large a pixel is.</source>
        <translation>Die Einzelbilder dieses Multiframe-Bildes sagen nicht, wie groß ein Pixel ist.</translation>
    </message>
    <message>
        <source>The images do not say how large a pixel is.</source>
        <translation>Die Bilder sagen nicht, wie groß ein Pixel ist.</translation>
    </message>
    <message>
        <source>The size of a pixel is not calibrated; it was taken from %1.</source>
        <translation>Die Pixelgröße ist nicht kalibriert; sie stammt aus: %1.</translation>
    </message>
    <message>
        <source>Do not measure lengths in these images.</source>
        <translation>Messen Sie in diesen Bildern keine Längen.</translation>
    </message>
    <message>
        <source>The orientation or pixel spacing of a slice is not a valid one.</source>
        <translation>Die Ausrichtung oder der Pixelabstand einer Schicht ist ungültig.</translation>
    </message>
    <message>
        <source>The row and column directions are %1 off perpendicular unit vectors, and were set right.</source>
        <translation>Die Richtungen von Zeilen und Spalten weichen um %1 von senkrechten Einheitsvektoren ab und wurden berichtigt.</translation>
    </message>
    <message>
        <source>Slices that are missing: %1 of %2, which are %3 mm apart.</source>
        <translation>Fehlende Schichten: %1 von %2, die %3 mm auseinander liegen.</translation>
    </message>
    <message>
        <source>Slices of the volume that are interpolated, because no image was there: %1 (%2).</source>
        <translation>Schichten des Volumens, die interpoliert sind, weil dort kein Bild war: %1 (%2).</translation>
    </message>
    <message>
        <source>Do not read anything into interpolated slices.</source>
        <translation>Deuten Sie nichts in interpolierte Schichten hinein.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced, %1 to %2 mm apart; they were resampled to an even %3 mm.</source>
        <translation>Die Schichten haben ungleiche Abstände von %1 bis %2 mm; sie wurden auf gleichmäßige %3 mm umgerechnet.</translation>
    </message>
    <message>
        <source>Look at the original images before measuring across slices.</source>
        <translation>Sehen Sie die Originalbilder an, bevor Sie über Schichten hinweg messen.</translation>
    </message>
    <message>
        <source>The slices are too unevenly spaced for a volume, %1 to %2 mm apart.</source>
        <translation>Die Schichten haben für ein Volumen zu ungleiche Abstände, %1 bis %2 mm.</translation>
    </message>
    <message>
        <source>Images whose position is missing or cannot be right, and that were left out of the volume: %1.</source>
        <translation>Bilder, deren Position fehlt oder nicht stimmen kann und die im Volumen fehlen: %1.</translation>
    </message>
    <message>
        <source>The slices are not quite evenly spaced: a slice is up to %1 mm away from where it is drawn.</source>
        <translation>Die Schichtabstände sind nicht ganz gleich: eine Schicht liegt bis zu %1 mm neben ihrem gezeigten Ort.</translation>
    </message>
    <message>
        <source>Allow for this error when measuring across slices.</source>
        <translation>Berücksichtigen Sie diesen Fehler beim Messen über Schichten hinweg.</translation>
    </message>
    <message>
        <source>The images are not parallel to each other.</source>
        <translation>Die Bilder sind nicht parallel zueinander.</translation>
    </message>
    <message>
        <source>The images do not make a volume: %1.</source>
        <translation>Die Bilder ergeben kein Volumen: %1.</translation>
    </message>
    <message>
        <source>their pixel spacings differ</source>
        <translation>ihre Pixelabstände unterscheiden sich</translation>
    </message>
    <message>
        <source>they are shifted sideways against each other</source>
        <translation>sie sind seitlich gegeneinander verschoben</translation>
    </message>
    <message>
        <source>they lie beside each other</source>
        <translation>sie liegen nebeneinander</translation>
    </message>
    <message>
        <source>each is shifted sideways against the one before</source>
        <translation>jedes ist gegen das vorige seitlich verschoben</translation>
    </message>
    <message>
        <source>their sizes differ</source>
        <translation>ihre Größen unterscheiden sich</translation>
    </message>
    <message>
        <source>they have no pixels</source>
        <translation>sie haben keine Pixel</translation>
    </message>
    <message>
        <source>a unit that is not named</source>
        <translation>einer ungenannten Einheit</translation>
    </message>
    <message>
        <source>the spacing at the detector</source>
        <translation>dem Abstand am Detektor</translation>
    </message>
    <message>
        <source>the nominal spacing of the scanned film</source>
        <translation>dem Nennabstand des gescannten Films</translation>
    </message>
    <message>
        <source>a factor that holds for all images</source>
        <translation>einem Faktor, der für alle Bilder gilt</translation>
    </message>
    <message>
        <source>The slices are stacked at an angle of %1 degrees (tilted gantry), and are drawn so.</source>
        <translation>Die Schichten sind unter einem Winkel von %1 Grad gestapelt (geneigte Gantry) und werden so gezeigt.</translation>
    </message>
    <message>
        <source>The slices are %1 mm thick and %2 mm apart: %3 % of what is between the first and the last was never imaged, and is interpolated here.</source>
        <translation>Die Schichten sind %1 mm dick und %2 mm auseinander: %3 % zwischen der ersten und der letzten wurde nie aufgenommen und ist hier interpoliert.</translation>
    </message>
    <message>
        <source>Do not read anything into what lies between the slices.</source>
        <translation>Deuten Sie nichts in das hinein, was zwischen den Schichten liegt.</translation>
    </message>
    <message>
        <source>Images of this kind (%1) are no slices of a volume.</source>
        <translation>Bilder dieser Art (%1) sind keine Schichten eines Volumens.</translation>
    </message>
    <message>
        <source>The images are in colour; a volume needs one value per voxel.</source>
        <translation>Die Bilder sind farbig; ein Volumen braucht einen Wert je Voxel.</translation>
    </message>
    <message>
        <source>The images do not say in a usable way which bits of a pixel hold its value: neither whole numbers in 1, 8, 16 or 32 bits nor floating point.</source>
        <translation>Die Bilder sagen nicht auf brauchbare Weise, welche Bits eines Pixels seinen Wert enthalten: weder ganze Zahlen in 1, 8, 16 oder 32 Bit noch Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>This version cannot decode the images: %1.</source>
        <translation>Diese Version kann die Bilder nicht dekodieren: %1.</translation>
    </message>
    <message>
        <source>Export the series uncompressed or in JPEG 2000.</source>
        <translation>Exportieren Sie die Serie unkomprimiert oder in JPEG 2000.</translation>
    </message>
    <message>
        <source>Images whose pixels this version cannot decode, and that were left out of the volume: %1.</source>
        <translation>Bilder, deren Pixel diese Version nicht dekodieren kann und die im Volumen fehlen: %1.</translation>
    </message>
    <message>
        <source>The images do not say how a value is shown; greater ones were taken as brighter.</source>
        <translation>Die Bilder sagen nicht, wie ein Wert gezeigt wird; größere wurden als heller angenommen.</translation>
    </message>
    <message>
        <source>Each image is a mosaic of many slices (Siemens), which this version does not unpack.</source>
        <translation>Jedes Bild ist ein Mosaik vieler Schichten (Siemens), das diese Version nicht zerlegt.</translation>
    </message>
    <message>
        <source>Export the series again as one image for each slice, or convert it with dcm2niix.</source>
        <translation>Exportieren Sie die Serie noch einmal mit einem Bild je Schicht, oder wandeln Sie sie mit dcm2niix um.</translation>
    </message>
    <message>
        <source>These values are a dose distribution (unit: %1), and no anatomy.</source>
        <translation>Diese Werte sind eine Dosisverteilung (Einheit: %1) und keine Anatomie.</translation>
    </message>
    <message>
        <source>Have the images exported again; other programs may not read them.</source>
        <translation>Lassen Sie die Bilder neu exportieren; andere Programme lesen sie vielleicht nicht.</translation>
    </message>
    <message>
        <source>The images say that their pixels are encoded as %1, and they are as %2, which they were read as.</source>
        <translation>Die Bilder geben an, ihre Pixel seien als %1 codiert; sie sind es als %2 und wurden so gelesen.</translation>
    </message>
    <message>
        <source>Look at both; values of one cannot be compared with those of the other.</source>
        <translation>Sehen Sie sich beide an; die Werte des einen sind nicht mit denen des anderen vergleichbar.</translation>
    </message>
    <message>
        <source>Images whose values are in another unit than those of the others, and that are a stack of their own: %1 (%2).</source>
        <translation>Bilder, deren Werte in einer anderen Einheit sind als die der übrigen und die ein eigener Stapel sind: %1 (%2).</translation>
    </message>
    <message>
        <source>To see anatomy, choose the images that the treatment was planned on.</source>
        <translation>Um Anatomie zu sehen, wählen Sie die Bilder, auf denen die Behandlung geplant wurde.</translation>
    </message>
    <message>
        <source>× reference dose</source>
        <translation>× Referenzdosis</translation>
    </message>
    <message>
        <source>not named</source>
        <translation>nicht genannt</translation>
    </message>
    <message>
        <source>another unit</source>
        <translation>eine andere Einheit</translation>
    </message>
    <message>
        <source>The values come from a lookup table in the images, which was applied.</source>
        <translation>Die Werte kommen aus einer Tabelle in den Bildern, die angewendet wurde.</translation>
    </message>
    <message>
        <source>The lookup table that makes values of the pixels is not a usable one.</source>
        <translation>Die Tabelle, die aus Pixeln Werte macht, ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>The rescale slope or intercept of an image is not a usable number.</source>
        <translation>Rescale Slope oder Intercept eines Bildes ist keine brauchbare Zahl.</translation>
    </message>
    <message>
        <source>Images that do not say how stored numbers become values: %1 of %2. A missing rescale slope was taken as 1, a missing intercept as 0.</source>
        <translation>Bilder, die nicht sagen, wie aus gespeicherten Zahlen Werte werden: %1 von %2. Ein fehlender Rescale Slope wurde als 1, ein fehlender Intercept als 0 angenommen.</translation>
    </message>
    <message>
        <source>Do not rely on the values; presets made for Hounsfield units may not fit.</source>
        <translation>Verlassen Sie sich nicht auf die Werte; Voreinstellungen für Hounsfield-Einheiten passen vielleicht nicht.</translation>
    </message>
    <message>
        <source>These CT images do not say that their values are Hounsfield units (%1); they are taken as plain numbers.</source>
        <translation>Diese CT-Bilder sagen nicht, dass ihre Werte Hounsfield-Einheiten sind (%1); sie gelten als einfache Zahlen.</translation>
    </message>
    <message>
        <source>Presets for Hounsfield units do not fit, and the table cannot be removed. Use the original images.</source>
        <translation>Voreinstellungen für Hounsfield-Einheiten passen nicht, und der Tisch kann nicht entfernt werden. Verwenden Sie die Originalbilder.</translation>
    </message>
    <message>
        <source>no rescale slope and intercept</source>
        <translation>kein Rescale Slope und Intercept</translation>
    </message>
    <message>
        <source>their rescale type is another</source>
        <translation>ihr Rescale Type ist ein anderer</translation>
    </message>
    <message>
        <source>their image type is that of a map, as of a material or of perfusion</source>
        <translation>ihr Image Type ist der einer Karte, etwa eines Materials oder der Perfusion</translation>
    </message>
    <message>
        <source>their lookup table does not say what it leads to</source>
        <translation>ihre Tabelle sagt nicht, wohin sie führt</translation>
    </message>
    <message>
        <source>pixels of 8 bits, as of a capture</source>
        <translation>Pixel mit 8 Bit, wie bei einem Capture</translation>
    </message>
    <message>
        <source>no usable description of the pixels</source>
        <translation>keine brauchbare Beschreibung der Pixel</translation>
    </message>
    <message>
        <source>they are no CT image objects</source>
        <translation>sie sind keine CT-Bildobjekte</translation>
    </message>
    <message>
        <source>Images whose rescale slope or intercept is missing or cannot be right, and that were left out of the volume: %1.</source>
        <translation>Bilder, deren Rescale Slope oder Intercept fehlt oder nicht stimmen kann und die im Volumen fehlen: %1.</translation>
    </message>
    <message>
        <source>Images whose rescale slope or intercept is another than that of all others; it was applied as it is: %1.</source>
        <translation>Bilder, deren Rescale Slope oder Intercept ein anderer ist als bei allen übrigen; er wurde so angewendet: %1.</translation>
    </message>
    <message>
        <source>Compare these slices with their neighbours; if they are brighter or darker, copy the series again from its source.</source>
        <translation>Vergleichen Sie diese Schichten mit ihren Nachbarn; sind sie heller oder dunkler, kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Each image has its own rescale factors; they are applied image by image.</source>
        <translation>Jedes Bild hat eigene Rescale-Faktoren; sie werden Bild für Bild angewendet.</translation>
    </message>
    <message>
        <source>The values are the real world values that the images define, in %1.</source>
        <translation>Die Werte sind die Real World Values, die die Bilder festlegen, in %1.</translation>
    </message>
    <message>
        <source>Standardised uptake values cannot be worked out: %1 is missing or not usable.</source>
        <translation>Standardisierte Aufnahmewerte (SUV) können nicht berechnet werden: %1 fehlt oder ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Images whose values need more bits than they say, and that were left out of the volume: %1.</source>
        <translation>Bilder, deren Werte mehr Bits brauchen, als sie angeben, und die im Volumen fehlen: %1.</translation>
    </message>
    <message>
        <source>Compare these slices with their neighbours, and copy the series again from its source.</source>
        <translation>Vergleichen Sie diese Schichten mit ihren Nachbarn, und kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Images that differ from both of their neighbours far more than these from each other; they are shown as they are: %1.</source>
        <translation>Bilder, die von beiden Nachbarn weit mehr abweichen als diese voneinander; sie werden gezeigt, wie sie sind: %1.</translation>
    </message>
    <message>
        <source>have one value, in whole or from some row on, between images that go on there</source>
        <translation>ganz oder ab einer Zeile einen einzigen Wert haben, zwischen Bildern, die dort weitergehen,</translation>
    </message>
    <message>
        <source>have their bytes in the wrong order</source>
        <translation>ihre Bytes in falscher Reihenfolge haben</translation>
    </message>
    <message>
        <source>have another sign than they say (PixelRepresentation)</source>
        <translation>ein anderes Vorzeichen haben, als sie angeben (PixelRepresentation),</translation>
    </message>
    <message>
        <source>Do not rely on the values; export the series again.</source>
        <translation>Verlassen Sie sich nicht auf die Werte; exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>Images whose pixels %1: %2 of %3. They are shown as the images say.</source>
        <translation>Bilder, deren Pixel %1: %2 von %3. Sie werden gezeigt, wie die Bilder es angeben.</translation>
    </message>
    <message>
        <source>Images whose pixels %1, and that were left out of the volume: %2.</source>
        <translation>Bilder, deren Pixel %1 und die im Volumen fehlen: %2.</translation>
    </message>
    <message>
        <source>Do not rely on values of this volume; export the series again.</source>
        <translation>Verlassen Sie sich nicht auf Werte dieses Volumens; exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>Places where the values jump because the rescale slope or intercept changes and the stored numbers do not: %1, first at slice %2, by %3. The values on one side are wrong.</source>
        <translation>Stellen, an denen die Werte springen, weil sich Rescale Slope oder Intercept ändert und die gespeicherten Zahlen nicht: %1, zuerst bei Schicht %2, um %3. Die Werte auf einer Seite sind falsch.</translation>
    </message>
    <message>
        <source>Images that say that their values lie higher in a pixel (HighBit) than the bits in use: %1 of %2. They were read from the lowest bit on; as the images say, values would be a fraction of these.</source>
        <translation>Bilder, die angeben, ihre Werte lägen höher im Pixel (HighBit) als die benutzten Bits: %1 von %2. Sie wurden vom niedrigsten Bit an gelesen; nach den Angaben wären die Werte ein Bruchteil davon.</translation>
    </message>
    <message>
        <source>Images with bits outside of those that they say hold the values: %1 of %2. These bits were dropped.</source>
        <translation>Bilder mit Bits außerhalb derer, die laut Angabe die Werte enthalten: %1 von %2. Diese Bits wurden weggelassen.</translation>
    </message>
    <message>
        <source>Compare the values with those that another program shows.</source>
        <translation>Vergleichen Sie die Werte mit denen, die ein anderes Programm zeigt.</translation>
    </message>
    <message>
        <source>Pixels that are no finite number: %1. They are treated as outside of the scan.</source>
        <translation>Pixel, die keine endliche Zahl sind: %1. Sie gelten als außerhalb der Aufnahme.</translation>
    </message>
    <message>
        <source>Do not read anything into the places where they are.</source>
        <translation>Deuten Sie nichts in die Stellen hinein, an denen sie sind.</translation>
    </message>
    <message>
        <source>The images were compressed with loss; fine detail may be missing or false.</source>
        <translation>Die Bilder wurden verlustbehaftet komprimiert; feine Einzelheiten können fehlen oder falsch sein.</translation>
    </message>
    <message>
        <source>Use the original images for diagnosis.</source>
        <translation>Verwenden Sie zur Diagnose die Originalbilder.</translation>
    </message>
    <message>
        <source>The images have lookup tables that say how they are shown (VOI LUT); these are not used, only windows are.</source>
        <translation>Die Bilder haben Tabellen, die sagen, wie sie gezeigt werden (VOI LUT); diese werden nicht verwendet, nur Fenster.</translation>
    </message>
    <message>
        <source>The images are meant to be shown with low values bright (MONOCHROME1); values are as stored.</source>
        <translation>Die Bilder sind dafür gedacht, niedrige Werte hell zu zeigen (MONOCHROME1); Werte sind wie gespeichert.</translation>
    </message>
    <message>
        <source>The letters of the sides (PatientOrientation) say the opposite of the orientation in space (ImageOrientationPatient), which is used, in %1 of %2 images.</source>
        <translation>Die Buchstaben der Seiten (PatientOrientation) sagen das Gegenteil der Orientierung im Raum (ImageOrientationPatient), die verwendet wird, in %1 von %2 Bildern.</translation>
    </message>
    <message>
        <source>Left and right, or front and back, may be exchanged: compare with the original images.</source>
        <translation>Links und rechts oder vorn und hinten können vertauscht sein: Vergleichen Sie mit den Originalbildern.</translation>
    </message>
    <message>
        <source>The display window of these images is not usable, and was ignored.</source>
        <translation>Die Fensterung dieser Bilder ist nicht brauchbar und wurde nicht beachtet.</translation>
    </message>
    <message>
        <source>%1 voxels belong to several segments; of each only the last is shown.</source>
        <translation>%1 Voxel gehören zu mehreren Segmenten; von jedem wird nur das letzte gezeigt.</translation>
    </message>
    <message>
        <source>Look at the segments one by one in the program that made them.</source>
        <translation>Sehen Sie die Segmente einzeln in dem Programm an, das sie erstellt hat.</translation>
    </message>
    <message>
        <source>%1 voxels of the segmentation lie outside of the volume, and are not shown.</source>
        <translation>%1 Voxel der Segmentierung liegen außerhalb des Volumens und werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>Check that no slices of the series are missing.</source>
        <translation>Prüfen Sie, ob Schichten der Serie fehlen.</translation>
    </message>
    <message>
        <source>Segment %1 has the number of the background (Pixel Padding Value): nothing of it is shown.</source>
        <translation>Segment %1 hat die Nummer des Hintergrunds (Pixel Padding Value): nichts davon wird gezeigt.</translation>
    </message>
    <message>
        <source>Look at it in the program that made it.</source>
        <translation>Sehen Sie es in dem Programm an, das es erstellt hat.</translation>
    </message>
    <message>
        <source>Segment 0 has the number %1 in the label map, in which 0 is none of the segments.</source>
        <translation>Segment 0 hat in der Label-Map die Nummer %1, denn dort ist 0 keines der Segmente.</translation>
    </message>
    <message>
        <source>The only volume%1.</source>
        <translation>Das einzige Volumen%1.</translation>
    </message>
    <message>
        <source>Of %1 volumes%2 the %3one %4with the most voxels (%5 x %6 x %7).</source>
        <translation>Von %1 Volumen%2 das %3%4mit den meisten Voxeln (%5 x %6 x %7).</translation>
    </message>
    <message>
        <source>it is no volume.</source>
        <translation>es ist kein Volumen.</translation>
    </message>
    <message>
        <source>of up to %1 patients in this folder</source>
        <translation>von bis zu %1 Patienten in diesem Ordner</translation>
    </message>
    <message>
        <source>of %1 patients in this folder</source>
        <translation>von %1 Patienten in diesem Ordner</translation>
    </message>
    <message>
        <source>in this series</source>
        <translation>in dieser Serie</translation>
    </message>
    <message>
        <source>Its series has %1 other stack of images.</source>
        <translation>Ihre Serie hat %1 weiteren Bildstapel.</translation>
    </message>
    <message>
        <source>Its series has %1 other stacks of images.</source>
        <translation>Ihre Serie hat %1 weitere Bildstapel.</translation>
    </message>
    <message>
        <source>There are no images.</source>
        <translation>Es gibt keine Bilder.</translation>
    </message>
    <message>
        <source>There are no images in this series.</source>
        <translation>In dieser Serie sind keine Bilder.</translation>
    </message>
    <message>
        <source>Nothing can be shown in 3D. The only stack of images: %1</source>
        <translation>Nichts kann in 3D gezeigt werden. Der einzige Bildstapel: %1</translation>
    </message>
    <message>
        <source>Nothing can be shown in 3D. The largest of %1 stacks of images: %2</source>
        <translation>Nichts kann in 3D gezeigt werden. Der größte von %1 Bildstapeln: %2</translation>
    </message>
    <message>
        <source>The image has no usable size.</source>
        <translation>Das Bild hat keine brauchbare Größe.</translation>
    </message>
    <message>
        <source>There is not enough memory to decode the image.</source>
        <translation>Es ist nicht genug Speicher da, um das Bild zu dekodieren.</translation>
    </message>
    <message>
        <source>Close other programs, or choose a smaller series.</source>
        <translation>Schließen Sie andere Programme, oder wählen Sie eine kleinere Serie.</translation>
    </message>
    <message>
        <source>This series is no volume.</source>
        <translation>Diese Serie ist kein Volumen.</translation>
    </message>
    <message>
        <source>The images of this series have no usable size.</source>
        <translation>Die Bilder dieser Serie haben keine brauchbare Größe.</translation>
    </message>
    <message>
        <source>The images of this series differ in size or in kind.</source>
        <translation>Die Bilder dieser Serie unterscheiden sich in Größe oder Art.</translation>
    </message>
    <message>
        <source>Export the series again.</source>
        <translation>Exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>%1 of the %2 images cannot be decoded. %3</source>
        <translation>%1 der %2 Bilder können nicht dekodiert werden. %3</translation>
    </message>
    <message>
        <source>Decoding %1 slices</source>
        <translation>%1 Schichten werden dekodiert</translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation>Das Laden wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is not enough memory to decode the slices.</source>
        <translation>Es ist nicht genug Speicher da, um die Schichten zu dekodieren.</translation>
    </message>
    <message>
        <source>There is not enough memory to decode a slice.</source>
        <translation>Es ist nicht genug Speicher da, um eine Schicht zu dekodieren.</translation>
    </message>
    <message>
        <source>%1 of %2 slices declare no padding value; that of the others was taken for them.</source>
        <translation>%1 von %2 Schichten nennen keinen Füllwert; für sie gilt der der anderen.</translation>
    </message>
    <message>
        <source>The compressed image in this file is damaged.</source>
        <translation>Das komprimierte Bild in dieser Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The JPEG 2000 image in this file cannot be decoded.</source>
        <translation>Das JPEG-2000-Bild in dieser Datei kann nicht dekodiert werden.</translation>
    </message>
    <message>
        <source>The pixel data of this file are damaged.</source>
        <translation>Die Pixeldaten dieser Datei sind beschädigt.</translation>
    </message>
    <message>
        <source>The file ends before its pixel data do.</source>
        <translation>Die Datei endet vor ihren Pixeldaten.</translation>
    </message>
    <message>
        <source>This version cannot decode this image: %1.</source>
        <translation>Diese Version kann dieses Bild nicht dekodieren: %1.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>Die Datei kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check that the file or disc is still there.</source>
        <translation>Prüfen Sie, ob Datei oder Datenträger noch da ist.</translation>
    </message>
    <message>
        <source>The file has changed since the folder was read.</source>
        <translation>Die Datei hat sich geändert, seit der Ordner gelesen wurde.</translation>
    </message>
    <message>
        <source>Open the folder again.</source>
        <translation>Öffnen Sie den Ordner noch einmal.</translation>
    </message>
    <message>
        <source>The file has no pixel data that fit its header.</source>
        <translation>Die Datei hat keine Pixeldaten, die zu ihrem Kopf passen.</translation>
    </message>
    <message>
        <source>It cannot be told where the images in this file begin.</source>
        <translation>Es ist nicht zu erkennen, wo die Bilder in dieser Datei beginnen.</translation>
    </message>
    <message>
        <source>The pixel data of this file cannot be decoded.</source>
        <translation>Die Pixeldaten dieser Datei können nicht dekodiert werden.</translation>
    </message>
    <message>
        <source>The images of this file have no usable size.</source>
        <translation>Die Bilder dieser Datei haben keine brauchbare Größe.</translation>
    </message>
    <message>
        <source>The folder does not exist.</source>
        <translation>Den Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation>Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>The folder cannot be read.</source>
        <translation>Der Ordner kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check that it is a folder, and its permissions.</source>
        <translation>Prüfen Sie, ob es ein Ordner ist, und seine Zugriffsrechte.</translation>
    </message>
    <message>
        <source>Reading was cancelled.</source>
        <translation>Das Lesen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The file is not the directory of a DICOM disc.</source>
        <translation>Die Datei ist nicht das Verzeichnis eines DICOM-Datenträgers.</translation>
    </message>
    <message>
        <source>Open the folder instead.</source>
        <translation>Öffnen Sie stattdessen den Ordner.</translation>
    </message>
    <message>
        <source>The only DICOM file in this folder cannot be read.</source>
        <translation>Die einzige DICOM-Datei in diesem Ordner kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>None of the %1 DICOM files in this folder can be read.</source>
        <translation>Keine der %1 DICOM-Dateien in diesem Ordner kann gelesen werden.</translation>
    </message>
    <message>
        <source>Copy the study again from its source.</source>
        <translation>Kopieren Sie die Studie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>There is no DICOM image in the folder, and some of its sub-folders cannot be read.</source>
        <translation>Im Ordner ist kein DICOM-Bild, und manche seiner Unterordner können nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check the permissions of the sub-folders.</source>
        <translation>Prüfen Sie die Zugriffsrechte der Unterordner.</translation>
    </message>
    <message>
        <source>There is no DICOM image in the folder itself; links that lead out of it are not followed.</source>
        <translation>Im Ordner selbst ist kein DICOM-Bild; Verknüpfungen, die hinausführen, wird nicht gefolgt.</translation>
    </message>
    <message>
        <source>Choose the folder that the links lead to.</source>
        <translation>Wählen Sie den Ordner, zu dem die Verknüpfungen führen.</translation>
    </message>
    <message>
        <source>The file is not a DICOM image.</source>
        <translation>Die Datei ist kein DICOM-Bild.</translation>
    </message>
    <message>
        <source>There is no DICOM image in this folder: the only file in it is none.</source>
        <translation>In diesem Ordner ist kein DICOM-Bild: Seine einzige Datei ist keines.</translation>
    </message>
    <message>
        <source>There is no DICOM image here but perhaps in an archive (zip), which is not opened.</source>
        <translation>Hier ist kein DICOM-Bild außer vielleicht in einem Archiv (zip), das nicht geöffnet wird.</translation>
    </message>
    <message>
        <source>Unpack it, and open the folder with what was in it.</source>
        <translation>Entpacken Sie es, und öffnen Sie den Ordner mit dem, was darin war.</translation>
    </message>
    <message>
        <source>There is no file in this folder.</source>
        <translation>In diesem Ordner ist keine Datei.</translation>
    </message>
    <message>
        <source>There is no DICOM image among the %1 files of this folder.</source>
        <translation>Unter den %1 Dateien dieses Ordners ist kein DICOM-Bild.</translation>
    </message>
    <message>
        <source>Choose a folder with DICOM images.</source>
        <translation>Wählen Sie einen Ordner mit DICOM-Bildern.</translation>
    </message>
    <message>
        <source>Looking for files</source>
        <translation>Dateien werden gesucht</translation>
    </message>
    <message>
        <source>Reading 1 file</source>
        <translation>1 Datei wird gelesen</translation>
    </message>
    <message>
        <source>Reading %1 files</source>
        <translation>%1 Dateien werden gelesen</translation>
    </message>
    <message>
        <source>Comparing %1 files</source>
        <translation>%1 Dateien werden verglichen</translation>
    </message>
    <message>
        <source>There is not enough memory to read this folder.</source>
        <translation>Es ist nicht genug Speicher da, um diesen Ordner zu lesen.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to read this folder.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um diesen Ordner zu lesen.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to read this folder.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, diesen Ordner zu lesen.</translation>
    </message>
    <message>
        <source>The program could not read this folder: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, diesen Ordner zu lesen: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>The program could not read this folder, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, diesen Ordner zu lesen, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>There is not enough memory to read the directory of this disc.</source>
        <translation>Es ist nicht genug Speicher da, um das Verzeichnis dieses Datenträgers zu lesen.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to read the directory of this disc.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um das Verzeichnis dieses Datenträgers zu lesen.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to read the directory of this disc.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, das Verzeichnis dieses Datenträgers zu lesen.</translation>
    </message>
    <message>
        <source>The program could not read the directory of this disc: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, das Verzeichnis dieses Datenträgers zu lesen: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>The program could not read the directory of this disc, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, das Verzeichnis dieses Datenträgers zu lesen, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to read a segmentation.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um eine Segmentierung zu lesen.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to read a segmentation.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, eine Segmentierung zu lesen.</translation>
    </message>
    <message>
        <source>The program could not read a segmentation: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, eine Segmentierung zu lesen: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>The program could not read a segmentation, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, eine Segmentierung zu lesen, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to load the segmentation.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um die Segmentierung zu laden.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to load the segmentation.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, die Segmentierung zu laden.</translation>
    </message>
    <message>
        <source>The program could not load the segmentation: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, die Segmentierung zu laden: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>The program could not load the segmentation, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, die Segmentierung zu laden, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to read the segmentations.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um die Segmentierungen zu lesen.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to read the segmentations.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, die Segmentierungen zu lesen.</translation>
    </message>
    <message>
        <source>The program could not read the segmentations: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, die Segmentierungen zu lesen: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>The program could not read the segmentations, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, die Segmentierungen zu lesen, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to decode the image.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um das Bild zu dekodieren.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to decode the image.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, das Bild zu dekodieren.</translation>
    </message>
    <message>
        <source>The program could not decode the image: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, das Bild zu dekodieren: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>The program could not decode the image, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, das Bild zu dekodieren, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>There is not enough memory to load this series.</source>
        <translation>Es ist nicht genug Speicher da, um diese Serie zu laden.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to load this series.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um diese Serie zu laden.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to load this series.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, diese Serie zu laden.</translation>
    </message>
    <message>
        <source>The program could not load this series: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, diese Serie zu laden: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>The program could not load this series, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, diese Serie zu laden, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>There is not enough memory to open this study.</source>
        <translation>Es ist nicht genug Speicher da, um diese Studie zu öffnen.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to open this study.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um diese Studie zu öffnen.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to open this study.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, diese Studie zu öffnen.</translation>
    </message>
    <message>
        <source>The program could not open this study: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, diese Studie zu öffnen: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>The program could not open this study, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, diese Studie zu öffnen, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>There is not enough memory to read this volume.</source>
        <translation>Es ist nicht genug Speicher da, um dieses Volumen zu lesen.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to read this volume.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um dieses Volumen zu lesen.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to read this volume.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, dieses Volumen zu lesen.</translation>
    </message>
    <message>
        <source>The program could not read this volume: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, dieses Volumen zu lesen: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>The program could not read this volume, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, dieses Volumen zu lesen, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>There is not enough memory to read the header of this volume.</source>
        <translation>Es ist nicht genug Speicher da, um den Kopf dieses Volumens zu lesen.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to read the header of this volume.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um den Kopf dieses Volumens zu lesen.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to read the header of this volume.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, den Kopf dieses Volumens zu lesen.</translation>
    </message>
    <message>
        <source>The program could not read the header of this volume: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, den Kopf dieses Volumens zu lesen: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>The program could not read the header of this volume, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, den Kopf dieses Volumens zu lesen, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>Close other programs, or choose something smaller.</source>
        <translation>Schließen Sie andere Programme, oder wählen Sie etwas Kleineres.</translation>
    </message>
    <message>
        <source>Check disk, connection and permissions, and try again.</source>
        <translation>Prüfen Sie Datenträger, Verbindung und Zugriffsrechte, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Copy it again from its source.</source>
        <translation>Kopieren Sie es noch einmal von seiner Quelle.</translation>
    </message>
    <message>
        <source>Try again; if it fails again, report it, with the log of the program.</source>
        <translation>Versuchen Sie es noch einmal; wenn es wieder misslingt, melden Sie es, mit dem Protokoll des Programms.</translation>
    </message>
    <message>
        <source>the background and the 98th percentile of the foreground</source>
        <translation>dem Hintergrund und dem 98. Perzentil des Vordergrunds</translation>
    </message>
    <message>
        <source>Whole numbers beyond 2^53 were rounded.</source>
        <translation>Ganze Zahlen jenseits von 2^53 wurden gerundet.</translation>
    </message>
    <message>
        <source>The values have 8 bytes each, as the size of the file tells, and not 4 as their type says.</source>
        <translation>Die Werte haben je 8 Bytes, wie die Größe der Datei sagt, und nicht 4, wie ihr Typ sagt.</translation>
    </message>
    <message>
        <source>The file with the values (.img) is missing.</source>
        <translation>Die Datei mit den Werten (.img) fehlt.</translation>
    </message>
    <message>
        <source>Volumes are not written to files with the ending %1.</source>
        <translation>Volumen werden nicht in Dateien mit der Endung %1 geschrieben.</translation>
    </message>
    <message>
        <source>The SPZ file names axes (number %1) that this version does not know.</source>
        <translation>Die SPZ-Datei nennt Achsen (Nummer %1), die diese Version nicht kennt.</translation>
    </message>
    <message>
        <source>Convert it to one with the axes of the format (right, up, back), or to PLY.</source>
        <translation>Wandeln Sie sie in eine mit den Achsen des Formats um (rechts, oben, hinten), oder in PLY.</translation>
    </message>
    <message>
        <source>Choose a smaller folder.</source>
        <translation>Wählen Sie einen kleineren Ordner.</translation>
    </message>
    <message>
        <source>The dictionary of the DICOM toolkit (dicom.dic) is not there, so that DICOM files cannot be read.</source>
        <translation>Das Wörterbuch des DICOM-Toolkits (dicom.dic) fehlt, sodass DICOM-Dateien nicht gelesen werden können.</translation>
    </message>
    <message>
        <source>Install DCMTK&apos;s data files again, or set DCMDICTPATH to the path of dicom.dic.</source>
        <translation>Installieren Sie die Datendateien von DCMTK noch einmal, oder setzen Sie DCMDICTPATH auf den Pfad von dicom.dic.</translation>
    </message>
    <message>
        <source>A picture of that size cannot be written as DICOM.</source>
        <translation>Ein Bild dieser Größe kann nicht als DICOM geschrieben werden.</translation>
    </message>
    <message>
        <source>Take 1 to %1 pixels for each side.</source>
        <translation>Nehmen Sie 1 bis %1 Pixel für jede Seite.</translation>
    </message>
    <message>
        <source>The files of this study do not say which patient and which study it is.</source>
        <translation>Die Dateien dieser Studie sagen nicht, welcher Patient und welche Studie es ist.</translation>
    </message>
    <message>
        <source>Write the picture without patient and study, or as PNG.</source>
        <translation>Speichern Sie das Bild ohne Patient und Studie oder als PNG.</translation>
    </message>
    <message>
        <source>The DICOM file could not be written.</source>
        <translation>Die DICOM-Datei konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Check free space and permissions.</source>
        <translation>Prüfen Sie freien Platz und Zugriffsrechte.</translation>
    </message>
    <message>
        <source>Check free space and memory.</source>
        <translation>Prüfen Sie freien Platz und Speicher.</translation>
    </message>
    <message>
        <source>The segmentation cannot be read.</source>
        <translation>Die Segmentierung kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Choose another segmentation.</source>
        <translation>Wählen Sie eine andere Segmentierung.</translation>
    </message>
    <message>
        <source>The file is no segmentation that this version knows.</source>
        <translation>Die Datei ist keine Segmentierung, die diese Version kennt.</translation>
    </message>
    <message>
        <source>There is not enough memory to load the segmentation.</source>
        <translation>Es ist nicht genug Speicher da, um die Segmentierung zu laden.</translation>
    </message>
    <message>
        <source>Close other programs.</source>
        <translation>Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>This is no image, and is not shown by itself: %1.</source>
        <translation>Das ist kein Bild und wird nicht für sich gezeigt: %1.</translation>
    </message>
    <message>
        <source>Presentation states of 3D views: %1; they are no images, and say how a series is shown.</source>
        <translation>Presentation States von 3D-Ansichten: %1; sie sind keine Bilder und sagen, wie eine Serie gezeigt wird.</translation>
    </message>
    <message>
        <source>Open its series, and in the window File, Open Presentation State, or give it to macula render.</source>
        <translation>Öffnen Sie die Serie dazu, dann im Fenster Datei, Presentation State öffnen, oder übergeben Sie ihn macula render.</translation>
    </message>
    <message>
        <source>The presentation state has %1, which cannot be shown.</source>
        <translation>Der Presentation State enthält %1; das kann nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>Compare with what the program shows that made it.</source>
        <translation>Vergleichen Sie mit dem, was das Programm zeigt, das ihn erstellt hat.</translation>
    </message>
    <message>
        <source>The presentation state has %1; %2.</source>
        <translation>Der Presentation State enthält %1; %2.</translation>
    </message>
    <message>
        <source>Another program changed this presentation state of Macula; it is shown as its standard attributes say.</source>
        <translation>Ein anderes Programm hat diesen Presentation State von Macula geändert; er wird gezeigt, wie es seine Standardattribute angeben.</translation>
    </message>
    <message>
        <source>The study that it belongs to cannot be read any more.</source>
        <translation>Die Studie, zu der es gehört, kann nicht mehr gelesen werden.</translation>
    </message>
    <message>
        <source>Open the study again, or write it without the patient.</source>
        <translation>Öffnen Sie die Studie noch einmal, oder speichern Sie es ohne den Patienten.</translation>
    </message>
    <message>
        <source>The DICOM file could not be made.</source>
        <translation>Die DICOM-Datei konnte nicht erstellt werden.</translation>
    </message>
    <message>
        <source>Check memory.</source>
        <translation>Prüfen Sie den Speicher.</translation>
    </message>
    <message>
        <source>Copy the file again from its source, or choose another presentation state.</source>
        <translation>Kopieren Sie die Datei noch einmal von ihrer Quelle, oder wählen Sie einen anderen Presentation State.</translation>
    </message>
    <message>
        <source>The presentation state does not say in which colours.</source>
        <translation>Der Presentation State sagt nicht, in welchen Farben.</translation>
    </message>
    <message>
        <source>several volumes blended into one picture</source>
        <translation>mehrere Volumen, zu einem Bild gemischt</translation>
    </message>
    <message>
        <source>colours of more than one input</source>
        <translation>Farben von mehr als einer Eingabe</translation>
    </message>
    <message>
        <source>The presentation state does not say which images it is of.</source>
        <translation>Der Presentation State sagt nicht, von welchen Bildern er ist.</translation>
    </message>
    <message>
        <source>more than one input</source>
        <translation>mehr als eine Eingabe</translation>
    </message>
    <message>
        <source>The presentation state is of something that is no volume.</source>
        <translation>Der Presentation State ist von etwas, das kein Volumen ist.</translation>
    </message>
    <message>
        <source>more than one set of images</source>
        <translation>mehr als einen Satz von Bildern</translation>
    </message>
    <message>
        <source>a registration to another frame of reference</source>
        <translation>eine Registrierung auf ein anderes Koordinatensystem</translation>
    </message>
    <message>
        <source>a sequence of volumes in time</source>
        <translation>eine zeitliche Folge von Volumen</translation>
    </message>
    <message>
        <source>The presentation state does not say which series it is of.</source>
        <translation>Der Presentation State sagt nicht, von welcher Serie er ist.</translation>
    </message>
    <message>
        <source>The presentation state does not say where it is looked from.</source>
        <translation>Der Presentation State sagt nicht, von wo aus er gesehen wird.</translation>
    </message>
    <message>
        <source>The presentation state is drawn by a method that Macula does not know.</source>
        <translation>Der Presentation State wird mit einem Verfahren gezeichnet, das Macula nicht kennt.</translation>
    </message>
    <message>
        <source>a window that is no straight line</source>
        <translation>eine Fensterung, die keine gerade Linie ist</translation>
    </message>
    <message>
        <source>a straight one is shown</source>
        <translation>eine gerade wird gezeigt</translation>
    </message>
    <message>
        <source>The colours of the presentation state are damaged.</source>
        <translation>Die Farben des Presentation State sind beschädigt.</translation>
    </message>
    <message>
        <source>The presentation state has a table of values (VOI LUT) before its colours, which Macula does not know.</source>
        <translation>Der Presentation State hat vor seinen Farben eine Wertetabelle (VOI LUT), die Macula nicht kennt.</translation>
    </message>
    <message>
        <source>The presentation state does not say which values its colours are of.</source>
        <translation>Der Presentation State sagt nicht, zu welchen Werten seine Farben gehören.</translation>
    </message>
    <message>
        <source>colours of another space</source>
        <translation>Farben eines anderen Farbraums</translation>
    </message>
    <message>
        <source>they are shown as sRGB</source>
        <translation>sie werden als sRGB gezeigt</translation>
    </message>
    <message>
        <source>A clip of the presentation state is missing in the file.</source>
        <translation>Ein Beschnitt des Presentation State fehlt in der Datei.</translation>
    </message>
    <message>
        <source>A clip of the presentation state is damaged.</source>
        <translation>Ein Beschnitt des Presentation State ist beschädigt.</translation>
    </message>
    <message>
        <source>a clip by a segmentation</source>
        <translation>einen Beschnitt durch eine Segmentierung</translation>
    </message>
    <message>
        <source>shading with numbers that are not 0 to 1</source>
        <translation>eine Schattierung mit Zahlen, die nicht 0 bis 1 sind</translation>
    </message>
    <message>
        <source>an animation</source>
        <translation>eine Animation</translation>
    </message>
    <message>
        <source>drawings or texts over the picture</source>
        <translation>Zeichnungen oder Texte über dem Bild</translation>
    </message>
    <message>
        <source>The presentation state cannot be read.</source>
        <translation>Der Presentation State kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file is not a DICOM presentation state.</source>
        <translation>Die Datei ist kein Presentation State in DICOM.</translation>
    </message>
    <message>
        <source>The file is no presentation state of one rendered volume.</source>
        <translation>Die Datei ist kein Presentation State eines gerenderten Volumens.</translation>
    </message>
    <message>
        <source>Choose a file of the kind Volume Rendering Volumetric Presentation State.</source>
        <translation>Wählen Sie eine Datei der Art Volume Rendering Volumetric Presentation State.</translation>
    </message>
    <message>
        <source>There is not enough memory for the presentation state.</source>
        <translation>Für den Presentation State ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>The presentation state could not be written.</source>
        <translation>Der Presentation State konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Choose another folder, and check free space and permissions.</source>
        <translation>Wählen Sie einen anderen Ordner, und prüfen Sie freien Platz und Rechte.</translation>
    </message>
    <message>
        <source>The presentation state could not be read.</source>
        <translation>Der Presentation State konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file may be damaged; choose another one.</source>
        <translation>Die Datei ist vielleicht beschädigt; wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>The label of the presentation state is not usable.</source>
        <translation>Die Bezeichnung des Presentation State ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Take 1 to 16 capital letters, digits, blanks and underscores.</source>
        <translation>Nehmen Sie 1 bis 16 Großbuchstaben, Ziffern, Leerzeichen und Unterstriche.</translation>
    </message>
    <message>
        <source>The description is too long, or has characters that it may not have.</source>
        <translation>Die Beschreibung ist zu lang oder hat Zeichen, die sie nicht haben darf.</translation>
    </message>
    <message>
        <source>Take at most 64 letters, digits and signs, without a backslash.</source>
        <translation>Nehmen Sie höchstens 64 Buchstaben, Ziffern und Zeichen, ohne umgekehrten Schrägstrich.</translation>
    </message>
    <message>
        <source>The view is too large for a presentation state.</source>
        <translation>Die Ansicht ist für einen Presentation State zu groß.</translation>
    </message>
    <message>
        <source>Save it as a view, or remove measurements and large presets from it.</source>
        <translation>Speichern Sie sie als Ansicht, oder entfernen Sie Messungen und große Voreinstellungen daraus.</translation>
    </message>
    <message>
        <source>The colours of the presentation state are not usable.</source>
        <translation>Die Farben des Presentation State sind nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose another preset, or a window above 0.</source>
        <translation>Wählen Sie eine andere Voreinstellung oder eine Fensterung über 0.</translation>
    </message>
    <message>
        <source>The camera of the presentation state is not usable.</source>
        <translation>Die Kamera des Presentation State ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose another view.</source>
        <translation>Wählen Sie eine andere Ansicht.</translation>
    </message>
    <message>
        <source>The clip of the presentation state is not usable.</source>
        <translation>Der Beschnitt des Presentation State ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose another clip.</source>
        <translation>Wählen Sie einen anderen Beschnitt.</translation>
    </message>
    <message>
        <source>The opacities of the presentation state are not usable.</source>
        <translation>Die Deckkräfte des Presentation State sind nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose another preset.</source>
        <translation>Wählen Sie eine andere Voreinstellung.</translation>
    </message>
    <message>
        <source>The shading of the presentation state is not usable.</source>
        <translation>Die Schattierung des Presentation State ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>A presentation state refers to DICOM images with a frame of reference, and this volume has none.</source>
        <translation>Ein Presentation State bezieht sich auf DICOM-Bilder mit einem Koordinatensystem, und dieses Volumen hat keines.</translation>
    </message>
    <message>
        <source>Save it as a view.</source>
        <translation>Speichern Sie sie als Ansicht.</translation>
    </message>
    <message>
        <source>Write the presentation state without patient and study.</source>
        <translation>Speichern Sie den Presentation State ohne Patient und Studie.</translation>
    </message>
    <message>
        <source>The pixels do not fit the size of the picture.</source>
        <translation>Die Pixel passen nicht zur Größe des Bildes.</translation>
    </message>
    <message>
        <source>Draw the picture again.</source>
        <translation>Zeichnen Sie das Bild noch einmal.</translation>
    </message>
    <message>
        <source>Take at most %1 letters, digits and signs, without a backslash.</source>
        <translation>Nehmen Sie höchstens %1 Buchstaben, Ziffern und Zeichen, ohne umgekehrten Schrägstrich.</translation>
    </message>
    <message>
        <source>The frames of the segmentation lie too far apart.</source>
        <translation>Die Einzelbilder der Segmentierung liegen zu weit auseinander.</translation>
    </message>
    <message>
        <source>Reading a segmentation of %1 frames</source>
        <translation>Eine Segmentierung mit %1 Einzelbildern wird gelesen</translation>
    </message>
    <message>
        <source>The segmentation ends before its last frame does.</source>
        <translation>Die Segmentierung endet vor ihrem letzten Einzelbild.</translation>
    </message>
    <message>
        <source>The segmentation changed while it was read.</source>
        <translation>Die Segmentierung hat sich beim Lesen geändert.</translation>
    </message>
    <message>
        <source>Open the study again.</source>
        <translation>Öffnen Sie die Studie noch einmal.</translation>
    </message>
    <message>
        <source>The frames of the segmentation do not lie on one grid.</source>
        <translation>Die Einzelbilder der Segmentierung liegen nicht auf einem Gitter.</translation>
    </message>
    <message>
        <source>Putting segments on the voxels of the volume</source>
        <translation>Segmente werden auf die Voxel des Volumens gelegt</translation>
    </message>
    <message>
        <source>The series of the segmentation is no volume.</source>
        <translation>Die Serie der Segmentierung ist kein Volumen.</translation>
    </message>
    <message>
        <source>The frames of the segmentation are of no kind that this version knows.</source>
        <translation>Die Einzelbilder der Segmentierung sind von keiner Art, die diese Version kennt.</translation>
    </message>
    <message>
        <source>The segmentation does not say what its values mean.</source>
        <translation>Die Segmentierung sagt nicht, was ihre Werte bedeuten.</translation>
    </message>
    <message>
        <source>The segmentation does not say where all of its frames lie.</source>
        <translation>Die Segmentierung sagt nicht, wo alle ihre Einzelbilder liegen.</translation>
    </message>
    <message>
        <source>The segmentation does not say where its frames lie.</source>
        <translation>Die Segmentierung sagt nicht, wo ihre Einzelbilder liegen.</translation>
    </message>
    <message>
        <source>The segmentation does not say what its frames show.</source>
        <translation>Die Segmentierung sagt nicht, was ihre Einzelbilder zeigen.</translation>
    </message>
    <message>
        <source>There is not enough memory to read a segmentation.</source>
        <translation>Es ist nicht genug Speicher da, um eine Segmentierung zu lesen.</translation>
    </message>
    <message>
        <source>The frames of the segmentation lie too far apart for a grid of their own.</source>
        <translation>Die Einzelbilder der Segmentierung liegen für ein eigenes Gitter zu weit auseinander.</translation>
    </message>
    <message>
        <source>Open it with the series it was drawn on.</source>
        <translation>Öffnen Sie sie mit der Serie, auf der sie gezeichnet wurde.</translation>
    </message>
    <message>
        <source>Frame %1 of the segmentation does not lie on the voxels of the series.</source>
        <translation>Einzelbild %1 der Segmentierung liegt nicht auf den Voxeln der Serie.</translation>
    </message>
    <message>
        <source>Open the segmentation with the series it was drawn on.</source>
        <translation>Öffnen Sie die Segmentierung mit der Serie, auf der sie gezeichnet wurde.</translation>
    </message>
    <message>
        <source>The segmentation has no frames.</source>
        <translation>Die Segmentierung hat keine Einzelbilder.</translation>
    </message>
    <message>
        <source>Object of class %1</source>
        <translation>Objekt der Klasse %1</translation>
    </message>
    <message>
        <source>The file is no presentation state of grey slices.</source>
        <translation>Die Datei ist kein Presentation State von grauen Schichten.</translation>
    </message>
    <message>
        <source>Choose a file of the kind Grayscale Softcopy Presentation State.</source>
        <translation>Wählen Sie eine Datei der Art Grayscale Softcopy Presentation State.</translation>
    </message>
    <message>
        <source>Presentation states: %1; they are no images, and say how a series is shown.</source>
        <translation>Presentation States: %1; sie sind keine Bilder und sagen, wie eine Serie gezeigt wird.</translation>
    </message>
    <message>
        <source>Open one of them in the list of studies; macula render draws those of 3D views.</source>
        <translation>Öffnen Sie einen davon in der Liste der Studien; macula render zeichnet die von 3D-Ansichten.</translation>
    </message>
</context>
<context>
    <name>formats</name>
    <message>
        <source>This is no MetaImage file.</source>
        <translation>Das ist keine MetaImage-Datei.</translation>
    </message>
    <message>
        <source>The image has several values in each voxel; a volume needs one.</source>
        <translation>Das Bild hat mehrere Werte in jedem Voxel; ein Volumen braucht einen.</translation>
    </message>
    <message>
        <source>The values of the image are neither whole numbers of 8 to 32 bits nor floating-point ones.</source>
        <translation>Die Werte des Bildes sind weder ganze Zahlen mit 8 bis 32 Bit noch Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>The size of a voxel is not calibrated: lengths, areas and volumes are estimates.</source>
        <translation>Die Größe eines Voxels ist nicht kalibriert: Längen, Flächen und Volumina sind Schätzungen.</translation>
    </message>
    <message>
        <source>The file does not give the distance of the voxels: 1 mm was assumed.</source>
        <translation>Die Datei nennt den Abstand der Voxel nicht: 1 mm wurde angenommen.</translation>
    </message>
    <message>
        <source>The values are written as text, which Macula does not read.</source>
        <translation>Die Werte sind als Text geschrieben, den Macula nicht liest.</translation>
    </message>
    <message>
        <source>Write the file with BinaryData = True.</source>
        <translation>Schreiben Sie die Datei mit BinaryData = True.</translation>
    </message>
    <message>
        <source>The values lie in several files.</source>
        <translation>Die Werte liegen in mehreren Dateien.</translation>
    </message>
    <message>
        <source>Write the volume to one file.</source>
        <translation>Schreiben Sie das Volumen in eine Datei.</translation>
    </message>
    <message>
        <source>Convert it with the program it comes from.</source>
        <translation>Wandeln Sie sie mit dem Programm um, aus dem sie kommt.</translation>
    </message>
    <message>
        <source>The file is cut off or damaged.</source>
        <translation>Die Datei ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>Get the file again from where it came.</source>
        <translation>Holen Sie die Datei noch einmal, woher sie kam.</translation>
    </message>
    <message>
        <source>Check the path and its permissions.</source>
        <translation>Prüfen Sie den Pfad und seine Zugriffsrechte.</translation>
    </message>
    <message>
        <source>This is no NIfTI file.</source>
        <translation>Das ist keine NIfTI-Datei.</translation>
    </message>
    <message>
        <source>The image is in colour; a volume needs one value in each voxel.</source>
        <translation>Das Bild ist farbig; ein Volumen braucht einen Wert in jedem Voxel.</translation>
    </message>
    <message>
        <source>The header of the NIfTI file is damaged.</source>
        <translation>Der Kopf der NIfTI-Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The file holds %1 volumes, one for each point in time; Macula reads one.</source>
        <translation>Die Datei enthält %1 Volumen, eines je Zeitpunkt; Macula liest eines.</translation>
    </message>
    <message>
        <source>Write one of them to a file of its own.</source>
        <translation>Schreiben Sie eines davon in eine eigene Datei.</translation>
    </message>
    <message>
        <source>The file gives two positions in the patient that differ by up to %1 mm (sform and qform): the sform was taken.</source>
        <translation>Die Datei gibt zwei Lagen im Patienten an, die um bis zu %1 mm abweichen (sform und qform): die sform wurde genommen.</translation>
    </message>
    <message>
        <source>The file does not say how the image lies in the patient: its axes were taken to lead to the right, to the front and up. Left and right may be exchanged.</source>
        <translation>Die Datei sagt nicht, wie das Bild im Patienten liegt: es wurde angenommen, dass seine Achsen nach rechts, vorn und oben führen. Links und rechts können vertauscht sein.</translation>
    </message>
    <message>
        <source>The file does not say how the image lies in the patient: its axes were taken to lead to the patient&apos;s left, back and head. Left and right may be exchanged.</source>
        <translation>Die Datei sagt nicht, wie das Bild im Patienten liegt: es wurde angenommen, dass seine Achsen nach links, hinten und zum Kopf des Patienten führen. Links und rechts können vertauscht sein.</translation>
    </message>
    <message>
        <source>This is an ANALYZE file, which does not tell left from right.</source>
        <translation>Das ist eine ANALYZE-Datei, die links und rechts nicht unterscheidet.</translation>
    </message>
    <message>
        <source>Write it as NIfTI.</source>
        <translation>Schreiben Sie sie als NIfTI.</translation>
    </message>
    <message>
        <source>The position of the image in the patient is not usable: its axes do not span a volume.</source>
        <translation>Die Lage des Bildes im Patienten ist nicht brauchbar: seine Achsen spannen kein Volumen auf.</translation>
    </message>
    <message>
        <source>This is no NRRD file.</source>
        <translation>Das ist keine NRRD-Datei.</translation>
    </message>
    <message>
        <source>The position of the image is not given in millimetres.</source>
        <translation>Die Lage des Bildes ist nicht in Millimetern angegeben.</translation>
    </message>
    <message>
        <source>Write one volume to a file of its own.</source>
        <translation>Schreiben Sie ein Volumen in eine eigene Datei.</translation>
    </message>
    <message>
        <source>The values are encoded in a way that Macula does not read.</source>
        <translation>Die Werte sind auf eine Weise kodiert, die Macula nicht liest.</translation>
    </message>
    <message>
        <source>Write the file with the encoding raw or gzip.</source>
        <translation>Schreiben Sie die Datei mit der Kodierung raw oder gzip.</translation>
    </message>
    <message>
        <source>Preparing the values</source>
        <translation>Die Werte werden vorbereitet</translation>
    </message>
    <message>
        <source>The file does not name the unit of its values: none was assumed. Presets for Hounsfield units do not fit.</source>
        <translation>Die Datei nennt die Einheit ihrer Werte nicht: keine wurde angenommen. Voreinstellungen für Hounsfield-Einheiten passen nicht.</translation>
    </message>
    <message>
        <source>Macula wrote this file, with values in %1; a program that changed them since need not have said so.</source>
        <translation>Macula hat diese Datei geschrieben, mit Werten in %1; ein Programm, das sie seither geändert hat, muss das nicht gesagt haben.</translation>
    </message>
    <message>
        <source>Values were rounded to 24 significant bits.</source>
        <translation>Werte wurden auf 24 signifikante Bits gerundet.</translation>
    </message>
    <message>
        <source>%1 voxels hold no finite number: they are treated as outside of the scan.</source>
        <translation>%1 Voxel enthalten keine endliche Zahl: sie gelten als außerhalb der Aufnahme.</translation>
    </message>
    <message>
        <source>The image of %1 x %2 x %3 voxels is no volume.</source>
        <translation>Das Bild aus %1 x %2 x %3 Voxeln ist kein Volumen.</translation>
    </message>
    <message>
        <source>Choose a file with a volume.</source>
        <translation>Wählen Sie eine Datei mit einem Volumen.</translation>
    </message>
    <message>
        <source>A volume of %1 x %2 x %3 voxels cannot be shown.</source>
        <translation>Ein Volumen aus %1 x %2 x %3 Voxeln kann nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>Choose a smaller one.</source>
        <translation>Wählen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>The file is cut off: its header tells of %1 x %2 x %3 voxels, and it is too short for them.</source>
        <translation>Die Datei ist abgeschnitten: ihr Kopf nennt %1 x %2 x %3 Voxel, und dafür ist sie zu kurz.</translation>
    </message>
    <message>
        <source>The map from stored values to units is not usable.</source>
        <translation>Die Abbildung gespeicherter Werte auf Einheiten ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Export the file again.</source>
        <translation>Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The header of the file is damaged.</source>
        <translation>Der Kopf der Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The image has two axes; it is no volume.</source>
        <translation>Das Bild hat zwei Achsen; es ist kein Volumen.</translation>
    </message>
    <message>
        <source>The image has %1 axes; Macula reads volumes with three.</source>
        <translation>Das Bild hat %1 Achsen; Macula liest Volumen mit drei.</translation>
    </message>
    <message>
        <source>The file with the values is missing.</source>
        <translation>Die Datei mit den Werten fehlt.</translation>
    </message>
    <message>
        <source>Put it beside the header.</source>
        <translation>Legen Sie sie neben den Kopf.</translation>
    </message>
    <message>
        <source>The ending of the name is that of no volume file.</source>
        <translation>Die Endung des Namens ist die keiner Volumendatei.</translation>
    </message>
    <message>
        <source>The file does not exist.</source>
        <translation>Die Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>There is not enough free space.</source>
        <translation>Es ist nicht genug Platz frei.</translation>
    </message>
    <message>
        <source>The file needs %1 MB.</source>
        <translation>Die Datei braucht %1 MB.</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>Es ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>There is not enough memory for this volume.</source>
        <translation>Es ist nicht genug Speicher für dieses Volumen da.</translation>
    </message>
    <message>
        <source>Close other programs, or choose a smaller one.</source>
        <translation>Schließen Sie andere Programme, oder wählen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>A NIfTI file holds no volume of %1 x %2 x %3 voxels.</source>
        <translation>Eine NIfTI-Datei fasst kein Volumen aus %1 x %2 x %3 Voxeln.</translation>
    </message>
    <message>
        <source>Write a .nrrd or .mha file.</source>
        <translation>Schreiben Sie eine .nrrd- oder .mha-Datei.</translation>
    </message>
    <message>
        <source>The values of the image have NIfTI's data type %1; Macula reads whole numbers of 8 to 32 bits and floating-point ones.</source>
        <translation>Die Werte des Bildes haben den NIfTI-Datentyp %1; Macula liest ganze Zahlen mit 8 bis 32 Bit und Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>The image has several values in each voxel, or an axis of time; a volume needs one value.</source>
        <translation>Das Bild hat mehrere Werte in jedem Voxel oder eine Zeitachse; ein Volumen braucht einen Wert.</translation>
    </message>
    <message>
        <source>An axis of the image does not lie in space.</source>
        <translation>Eine Achse des Bildes liegt nicht im Raum.</translation>
    </message>
    <message>
        <source>Text stands before the values, which Macula does not read.</source>
        <translation>Vor den Werten steht Text, den Macula nicht liest.</translation>
    </message>
    <message>
        <source>The values lie in another folder or in several files.</source>
        <translation>Die Werte liegen in einem anderen Ordner oder in mehreren Dateien.</translation>
    </message>
    <message>
        <source>Write the volume to one file, or put the file with the values beside the header.</source>
        <translation>Schreiben Sie das Volumen in eine Datei, oder legen Sie die Datei mit den Werten neben den Kopf.</translation>
    </message>
    <message>
        <source>The file could not be put in place: %1.</source>
        <translation>Die Datei konnte nicht an ihren Ort gelegt werden: %1.</translation>
    </message>
</context>
<context>
    <name>segment</name>
    <message>
        <source>The patient could not be told from the table.</source>
        <translation>Der Patient konnte nicht vom Tisch unterschieden werden.</translation>
    </message>
    <message>
        <source>Close other programs, or show the volume with the table.</source>
        <translation>Schließen Sie andere Programme, oder zeigen Sie das Volumen mit dem Tisch.</translation>
    </message>
    <message>
        <source>The table is left out, and whatever else lies apart from the patient: %1, %2 (confidence %3).</source>
        <translation>Der Tisch und was sonst abseits des Patienten liegt, ist weggelassen: %1, %2 (Sicherheit: %3).</translation>
    </message>
    <message>
        <source>Show the table again to see everything that was scanned.</source>
        <translation>Zeigen Sie den Tisch wieder, um alles Aufgenommene zu sehen.</translation>
    </message>
    <message>
        <source>≈ %1 mL, not calibrated</source>
        <translation>≈ %1 mL, nicht kalibriert</translation>
    </message>
    <message>
        <source>No table was found. What lies apart from the patient is left out: %1, %2 (confidence %3).</source>
        <translation>Kein Tisch wurde gefunden. Was abseits des Patienten liegt, ist weggelassen: %1, %2 (Sicherheit: %3).</translation>
    </message>
    <message>
        <source>1 part</source>
        <translation>1 Teil</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 Teile</translation>
    </message>
    <message>
        <source>Nothing lies apart from the patient; nothing is left out.</source>
        <translation>Nichts liegt abseits des Patienten; nichts ist weggelassen.</translation>
    </message>
    <message>
        <source>The patient lies against the table in %1 of %2 slices of the search grid; the surface between them is an estimate there, to about 3 mm.</source>
        <translation>Der Patient liegt in %1 von %2 Schichten des Suchgitters am Tisch an; die Fläche dazwischen ist dort auf etwa 3 mm geschätzt.</translation>
    </message>
    <message>
        <source>Do not judge the skin of the side that the patient lies on; show the table again for that.</source>
        <translation>Beurteilen Sie die Haut der Seite nicht, auf der der Patient liegt; zeigen Sie dafür den Tisch wieder.</translation>
    </message>
    <message>
        <source>It is not clear what is patient and what is table; nothing is left out.</source>
        <translation>Es ist nicht klar, was Patient und was Tisch ist; nichts ist weggelassen.</translation>
    </message>
    <message>
        <source>Cut the table away with a clip plane or box.</source>
        <translation>Schneiden Sie den Tisch mit einer Schnittebene oder einem Quader weg.</translation>
    </message>
    <message>
        <source>No patient was found in these images; nothing is left out.</source>
        <translation>In diesen Bildern wurde kein Patient gefunden; nichts ist weggelassen.</translation>
    </message>
    <message>
        <source>Telling the patient from the table was cancelled.</source>
        <translation>Die Suche nach dem Tisch wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Telling the patient from the table</source>
        <translation>Patient und Tisch werden unterschieden</translation>
    </message>
    <message>
        <source>The table can be left out of CT in Hounsfield units only.</source>
        <translation>Der Tisch kann nur bei CT in Hounsfield-Einheiten weggelassen werden.</translation>
    </message>
    <message>
        <source>Show these images with the table, or cut it away with a clip plane or box.</source>
        <translation>Zeigen Sie diese Bilder mit dem Tisch, oder schneiden Sie ihn mit einer Schnittebene oder einem Quader weg.</translation>
    </message>
    <message>
        <source>There is not enough memory to tell the patient from the table.</source>
        <translation>Es ist nicht genug Speicher da, um Patient und Tisch zu unterscheiden.</translation>
    </message>
</context>
<context>
    <name>base</name>
    <message>
        <source>The file could not be written.</source>
        <translation>Die Datei konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The file could not be written: %1.</source>
        <translation>Die Datei konnte nicht geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>The file is larger than %1 bytes.</source>
        <translation>Die Datei ist größer als %1 Bytes.</translation>
    </message>
    <message>
        <source>Check that it is the file you meant.</source>
        <translation>Prüfen Sie, ob es die gemeinte Datei ist.</translation>
    </message>
    <message>
        <source>The file could not be read.</source>
        <translation>Die Datei konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>There is not enough memory for this series: it needs %1, and %2 are free.</source>
        <translation>Für diese Serie ist nicht genug Speicher da: sie braucht %1, und %2 sind frei.</translation>
    </message>
    <message>
        <source>There is not enough memory for this series: it needs %1.</source>
        <translation>Für diese Serie ist nicht genug Speicher da: sie braucht %1.</translation>
    </message>
    <message>
        <source>The system has no random numbers.</source>
        <translation>Das System hat keine Zufallszahlen.</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The folder to write into does not exist.</source>
        <translation>Den Zielordner gibt es nicht.</translation>
    </message>
    <message>
        <source>Create it, or choose another place.</source>
        <translation>Legen Sie ihn an, oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>What stands there is no file.</source>
        <translation>Was dort steht, ist keine Datei.</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>A part of Macula could not be loaded.</source>
        <translation>Ein Teil von Macula konnte nicht geladen werden.</translation>
    </message>
    <message>
        <source>Install Macula again, with the packages that it depends on.</source>
        <translation>Installieren Sie Macula noch einmal, mit den Paketen, die es braucht.</translation>
    </message>
    <message>
        <source>The position of the voxels in the patient is not usable: the axes do not span a volume.</source>
        <translation>Die Lage der Voxel im Patienten ist nicht brauchbar: die Achsen spannen kein Volumen auf.</translation>
    </message>
    <message>
        <source>The 3D picture has values of 16 bits, with an error of at most %1.</source>
        <translation>Das 3D-Bild hat Werte von 16 Bit, mit einem Fehler von höchstens %1.</translation>
    </message>
    <message>
        <source>The 3D picture has values of 16 bits, with an error of at most %1 %2.</source>
        <translation>Das 3D-Bild hat Werte von 16 Bit, mit einem Fehler von höchstens %1 %2.</translation>
    </message>
    <message>
        <source>The 3D picture shows values below %1 or above %2 as these.</source>
        <translation>Das 3D-Bild zeigt Werte unter %1 oder über %2 wie diese.</translation>
    </message>
    <message>
        <source>The presentation state is of the values of the images, and this PET is shown in SUV.</source>
        <translation>Der Presentation State gilt für die Werte der Bilder, und dieses PET wird in SUV gezeigt.</translation>
    </message>
    <message>
        <source>Choose a preset or a window in SUV.</source>
        <translation>Wählen Sie eine Voreinstellung oder ein Fenster in SUV.</translation>
    </message>
    <message>
        <source>Correct the camera.</source>
        <translation>Berichtigen Sie die Kamera.</translation>
    </message>
    <message>
        <source>The camera has a number that is not finite.</source>
        <translation>Die Kamera hat eine Zahl, die nicht endlich ist.</translation>
    </message>
    <message>
        <source>The camera's vertical field of view must lie between 0.1 and 170 degrees.</source>
        <translation>Das senkrechte Blickfeld der Kamera muss zwischen 0,1 und 170 Grad liegen.</translation>
    </message>
    <message>
        <source>The height of a parallel picture must lie between 0.001 mm and 1 km.</source>
        <translation>Die Höhe eines parallelen Bildes muss zwischen 0,001 mm und 1 km liegen.</translation>
    </message>
    <message>
        <source>The camera's position and target are the same point.</source>
        <translation>Ort und Ziel der Kamera sind derselbe Punkt.</translation>
    </message>
    <message>
        <source>The camera's up direction is parallel to its view.</source>
        <translation>Die Richtung nach oben der Kamera ist parallel zu ihrem Blick.</translation>
    </message>
    <message>
        <source>The segmentation has no voxels.</source>
        <translation>Die Segmentierung hat keine Voxel.</translation>
    </message>
    <message>
        <source>The segmentation has not as many voxels as its size says.</source>
        <translation>Die Segmentierung hat nicht so viele Voxel, wie ihre Größe angibt.</translation>
    </message>
    <message>
        <source>The segmentation does not say where it lies.</source>
        <translation>Die Segmentierung sagt nicht, wo sie liegt.</translation>
    </message>
    <message>
        <source>The volume should have %1 voxels, and has %2.</source>
        <translation>Das Volumen sollte %1 Voxel haben und hat %2.</translation>
    </message>
</context>
<context>
    <name>app</name>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
    <message>
        <source>A picture of light has no cube, scale and letters over it.</source>
        <translation>Über einem Bild aus Licht liegen weder Würfel noch Maßstab und Buchstaben.</translation>
    </message>
    <message>
        <source>There is no such preset.</source>
        <translation>Diese Voreinstellung gibt es nicht.</translation>
    </message>
    <message>
        <source>There are no such lights.</source>
        <translation>Diese Beleuchtung gibt es nicht.</translation>
    </message>
    <message>
        <source>The place of the clip is not a number.</source>
        <translation>Der Ort des Beschnitts ist keine Zahl.</translation>
    </message>
    <message>
        <source>Give it in mm.</source>
        <translation>Geben Sie ihn in mm an.</translation>
    </message>
    <message>
        <source>Nothing of the volume would be left.</source>
        <translation>Vom Volumen bliebe nichts übrig.</translation>
    </message>
    <message>
        <source>Choose another place, or begin without a clip.</source>
        <translation>Wählen Sie einen anderen Ort, oder beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>A clip with a box of another kind has six planes and no more.</source>
        <translation>Ein Beschnitt mit einem anderen Quader hat sechs Ebenen und nicht mehr.</translation>
    </message>
    <message>
        <source>Open another face first, or begin without a clip.</source>
        <translation>Öffnen Sie zuerst eine andere Fläche, oder beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>Nothing is left to remove on the %1 side.</source>
        <translation>Auf der Seite %1 ist nichts mehr zu entfernen.</translation>
    </message>
    <message>
        <source>Move the cross-hair into what is shown.</source>
        <translation>Bewegen Sie das Fadenkreuz in das Gezeigte.</translation>
    </message>
    <message>
        <source>The slab has no thickness.</source>
        <translation>Der Slab hat keine Dicke.</translation>
    </message>
    <message>
        <source>Give it in mm, more than 0.</source>
        <translation>Geben Sie sie in mm an, größer als 0.</translation>
    </message>
    <message>
        <source>The slab would be outside of the volume.</source>
        <translation>Der Slab läge außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>Move the cross-hair into the volume.</source>
        <translation>Bewegen Sie das Fadenkreuz in das Volumen.</translation>
    </message>
    <message>
        <source>The corner would be outside of the volume.</source>
        <translation>Die Ecke läge außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>A ball of that size is not possible here.</source>
        <translation>Eine Kugel dieser Größe ist hier nicht möglich.</translation>
    </message>
    <message>
        <source>Give a radius from %1 to %2 mm.</source>
        <translation>Geben Sie einen Radius von %1 bis %2 mm an.</translation>
    </message>
    <message>
        <source>The ball would be outside of the volume.</source>
        <translation>Die Kugel läge außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>There is no clip to turn inside out.</source>
        <translation>Es gibt keinen Beschnitt zum Umkehren.</translation>
    </message>
    <message>
        <source>Choose a clip, or cut something off.</source>
        <translation>Wählen Sie einen Beschnitt, oder schneiden Sie etwas ab.</translation>
    </message>
    <message>
        <source>Only a clip of one part can be turned inside out.</source>
        <translation>Nur ein Beschnitt aus einem Teil kann umgekehrt werden.</translation>
    </message>
    <message>
        <source>This one has %1; begin without a clip.</source>
        <translation>Dieser hat %1; beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>The clip leaves nothing of this volume.</source>
        <translation>Der Beschnitt lässt von diesem Volumen nichts übrig.</translation>
    </message>
    <message>
        <source>Begin again without a clip.</source>
        <translation>Beginnen Sie noch einmal ohne Beschnitt.</translation>
    </message>
    <message>
        <source>preview only</source>
        <translation>nur Vorschau</translation>
    </message>
    <message>
        <source>estimated from the values</source>
        <translation>aus den Werten geschätzt</translation>
    </message>
    <message>
        <source>preview around the sharp centre</source>
        <translation>Vorschau um die scharfe Mitte</translation>
    </message>
    <message>
        <source>sharp centre traced %1 s ago with %2 samples</source>
        <translation>scharfe Mitte vor %1 s mit %2 Abtastungen verfolgt</translation>
    </message>
    <message>
        <source>values on cut faces only coarsely</source>
        <translation>Werte auf Schnittflächen nur grob</translation>
    </message>
    <message>
        <source>preview fades out</source>
        <translation>Vorschau blendet aus</translation>
    </message>
    <message>
        <source>preview where it is less noisy</source>
        <translation>Vorschau, wo sie weniger rauscht</translation>
    </message>
    <message>
        <source>1/%1 of the pixels each way</source>
        <translation>1/%1 der Pixel je Richtung</translation>
    </message>
    <message>
        <source>%1 of %2 samples</source>
        <translation>%1 von %2 Abtastungen</translation>
    </message>
    <message>
        <source>less than the full resolution</source>
        <translation>weniger als die volle Auflösung</translation>
    </message>
    <message>
        <source>denoised</source>
        <translation>entrauscht</translation>
    </message>
    <message>
        <source>%1 samples left out</source>
        <translation>%1 Abtastungen ausgelassen</translation>
    </message>
    <message>
        <source>shaded</source>
        <translation>schattiert</translation>
    </message>
    <message>
        <source>hues kept</source>
        <translation>Farbtöne erhalten</translation>
    </message>
    <message>
        <source>table left out</source>
        <translation>Tisch weggelassen</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>beschnitten</translation>
    </message>
    <message>
        <source>There was no memory to keep the peripheral model.</source>
        <translation>Es war kein Speicher da, um das periphere Modell zu behalten.</translation>
    </message>
    <message>
        <source>There is not enough memory to show this study.</source>
        <translation>Es ist nicht genug Speicher da, um diese Studie zu zeigen.</translation>
    </message>
    <message>
        <source>Close other programs, or open a smaller series.</source>
        <translation>Schließen Sie andere Programme, oder öffnen Sie eine kleinere Serie.</translation>
    </message>
    <message>
        <source>The picture could not be made.</source>
        <translation>Das Bild konnte nicht erstellt werden.</translation>
    </message>
    <message>
        <source>Open the study again, or start the program with another --device.</source>
        <translation>Öffnen Sie die Studie noch einmal, oder starten Sie das Programm mit einem anderen --device.</translation>
    </message>
    <message>
        <source>Starting the graphics device</source>
        <translation>Das Grafikgerät wird gestartet</translation>
    </message>
    <message>
        <source>Preparing the volume</source>
        <translation>Das Volumen wird vorbereitet</translation>
    </message>
    <message>
        <source>Preparing what is shown</source>
        <translation>Das Gezeigte wird vorbereitet</translation>
    </message>
    <message>
        <source>There is no room on the device for a traced fovea.</source>
        <translation>Auf dem Gerät ist kein Platz für eine verfolgte Fovea.</translation>
    </message>
    <message>
        <source>There is not enough memory for it.</source>
        <translation>Dafür ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>There is no room on the device to denoise a picture of this size.</source>
        <translation>Auf dem Gerät ist kein Platz, um ein Bild dieser Größe zu entrauschen.</translation>
    </message>
    <message>
        <source>Measurements are written to a .csv or .json file.</source>
        <translation>Messungen werden in eine .csv- oder .json-Datei geschrieben.</translation>
    </message>
    <message>
        <source>Choose a name with one of these endings.</source>
        <translation>Wählen Sie einen Namen mit einer dieser Endungen.</translation>
    </message>
    <message>
        <source>There is a folder of that name.</source>
        <translation>Es gibt einen Ordner dieses Namens.</translation>
    </message>
    <message>
        <source>Nothing can be written there.</source>
        <translation>Dort kann nichts geschrieben werden.</translation>
    </message>
    <message>
        <source>Check the permissions, or choose another place.</source>
        <translation>Prüfen Sie die Zugriffsrechte, oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The file belongs to the folder that is read.</source>
        <translation>Die Datei gehört zu dem Ordner, der gelesen wird.</translation>
    </message>
    <message>
        <source>The file is one of those that are read.</source>
        <translation>Die Datei ist eine von denen, die gelesen werden.</translation>
    </message>
    <message>
        <source>Choose another name: what is read is never replaced.</source>
        <translation>Wählen Sie einen anderen Namen: was gelesen wird, wird nie ersetzt.</translation>
    </message>
    <message>
        <source>The file exists already.</source>
        <translation>Die Datei gibt es schon.</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Tracing until the noise is gone</source>
        <translation>Verfolgt, bis das Rauschen weg ist</translation>
    </message>
    <message>
        <source>The picture is noisier than its limit of noise.</source>
        <translation>Das Bild rauscht stärker als seine Grenze für Rauschen.</translation>
    </message>
    <message>
        <source>The picture must be a .png or .exr file.</source>
        <translation>Das Bild muss eine .png- oder .exr-Datei sein.</translation>
    </message>
    <message>
        <source>The picture cannot have that size.</source>
        <translation>Das Bild kann diese Größe nicht haben.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation>Für dieses Bild ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Choose a smaller size, or close other programs.</source>
        <translation>Wählen Sie eine kleinere Größe, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>%1 samples were not finite and were dropped; please report this.</source>
        <translation>%1 Abtastungen waren nicht endlich und wurden weggelassen; bitte melden Sie das.</translation>
    </message>
    <message>
        <source>Light met matter %1 times that was denser than its bound, and passed too easily; please report this.</source>
        <translation>Licht traf %1-mal auf Materie, die dichter war als ihre Schranke, und drang zu leicht hindurch; bitte melden Sie dies.</translation>
    </message>
    <message>
        <source>%1 light paths were too long for the device and were dropped.</source>
        <translation>%1 Lichtpfade waren zu lang für das Gerät und wurden weggelassen.</translation>
    </message>
    <message>
        <source>There is not enough memory to keep this study&apos;s model.</source>
        <translation>Es ist nicht genug Speicher da, um das Modell dieser Studie zu behalten.</translation>
    </message>
    <message>
        <source>The file of stored sessions was damaged. It was set aside, and what could be read of it was rescued.</source>
        <translation>Die Datei der gespeicherten Sitzungen war beschädigt. Sie wurde beiseitegelegt, und was davon lesbar war, wurde gerettet.</translation>
    </message>
    <message>
        <source>`macula sessions verify` says what is there.</source>
        <translation>`macula sessions verify` sagt, was da ist.</translation>
    </message>
    <message>
        <source>`macula sessions verify` says what else is.</source>
        <translation>`macula sessions verify` sagt, was es noch ist.</translation>
    </message>
    <message>
        <source>A stored model is damaged, and is not used.</source>
        <translation>Ein gespeichertes Modell ist beschädigt und wird nicht verwendet.</translation>
    </message>
    <message>
        <source>How this study was left was not found in time.</source>
        <translation>Wie diese Studie verlassen wurde, wurde nicht rechtzeitig gefunden.</translation>
    </message>
    <message>
        <source>It is kept: open the study again to see it.</source>
        <translation>Es bleibt aufbewahrt: öffnen Sie die Studie noch einmal, um es zu sehen.</translation>
    </message>
    <message>
        <source>More was measured on this study than is shown here: another window has it open, or had.</source>
        <translation>An dieser Studie wurde mehr gemessen, als hier gezeigt wird: ein anderes Fenster hat sie offen oder hatte sie offen.</translation>
    </message>
    <message>
        <source>All of it is kept; open the study again to see it.</source>
        <translation>Alles davon bleibt aufbewahrt; öffnen Sie die Studie noch einmal, um es zu sehen.</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Of the series</source>
        <translation>Der Serie</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alle Werte</translation>
    </message>
    <message>
        <source>The view was saved when the images lay in other places, or of another volume of the series.</source>
        <translation>Die Ansicht wurde gespeichert, als die Bilder an anderen Orten lagen, oder von einem anderen Volumen der Serie.</translation>
    </message>
    <message>
        <source>Make it anew; or choose the volume that it is of. Without "grid" in the file it is taken as it is.</source>
        <translation>Machen Sie sie neu, oder wählen Sie das Volumen, von dem sie ist. Ohne „grid“ in der Datei wird sie genommen, wie sie ist.</translation>
    </message>
    <message>
        <source>The view was saved of another series.</source>
        <translation>Die Ansicht wurde von einer anderen Serie gespeichert.</translation>
    </message>
    <message>
        <source>Open that series, or choose another view.</source>
        <translation>Öffnen Sie diese Serie, oder wählen Sie eine andere Ansicht.</translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation>Keine Studie ist offen.</translation>
    </message>
    <message>
        <source>Open the study that the view is of first.</source>
        <translation>Öffnen Sie zuerst die Studie der Ansicht.</translation>
    </message>
    <message>
        <source>Choose a folder with a CT or MR series of several parallel slices.</source>
        <translation>Wählen Sie einen Ordner mit einer CT- oder MR-Serie aus mehreren parallelen Schichten.</translation>
    </message>
    <message>
        <source>Modality unknown</source>
        <translation>Modalität unbekannt</translation>
    </message>
    <message>
        <source>volume %1 of %2</source>
        <translation>Volumen %1 von %2</translation>
    </message>
    <message>
        <source>series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>series without a number</source>
        <translation>Serie ohne Nummer</translation>
    </message>
    <message>
        <source>no description</source>
        <translation>keine Beschreibung</translation>
    </message>
    <message>
        <source>phase %1 of %2</source>
        <translation>Phase %1 von %2</translation>
    </message>
    <message>
        <source>no study date</source>
        <translation>kein Studiendatum</translation>
    </message>
    <message>
        <source>The images of the file that was opened.</source>
        <translation>Die Bilder der geöffneten Datei.</translation>
    </message>
    <message>
        <source>The images are no volume.</source>
        <translation>Die Bilder sind kein Volumen.</translation>
    </message>
    <message>
        <source>No patient name</source>
        <translation>Kein Patientenname</translation>
    </message>
    <message>
        <source>No patient ID</source>
        <translation>Keine Patienten-ID</translation>
    </message>
    <message>
        <source>no patient ID</source>
        <translation>keine Patienten-ID</translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation>Das Phantom wird erstellt</translation>
    </message>
    <message>
        <source>Built-in phantom</source>
        <translation>Eingebautes Phantom</translation>
    </message>
    <message>
        <source>The volume that was chosen.</source>
        <translation>Das gewählte Volumen.</translation>
    </message>
    <message>
        <source>Series %1 (%2 images) could not be opened: %3</source>
        <translation>Serie %1 (%2 Bilder) konnte nicht geöffnet werden: %3</translation>
    </message>
    <message>
        <source>A series without a number (%1 images) could not be opened: %2</source>
        <translation>Eine Serie ohne Nummer (%1 Bilder) konnte nicht geöffnet werden: %2</translation>
    </message>
    <message>
        <source>The best of the other volumes is shown instead.</source>
        <translation>Stattdessen wird das beste der anderen Volumen gezeigt.</translation>
    </message>
    <message>
        <source>The best of the other volumes is shown instead, which is of another patient.</source>
        <translation>Stattdessen wird das beste der anderen Volumen gezeigt, das von einem anderen Patienten ist.</translation>
    </message>
    <message>
        <source>The best volume that can be opened.</source>
        <translation>Das beste Volumen, das sich öffnen lässt.</translation>
    </message>
    <message>
        <source>%1 file was left out; the list of studies and `macula info` on the folder say why.</source>
        <translation>%1 Datei wurde weggelassen; die Liste der Studien und `macula info` zum Ordner sagen, warum.</translation>
    </message>
    <message>
        <source>%1 files were left out; the list of studies and `macula info` on the folder say why.</source>
        <translation>%1 Dateien wurden weggelassen; die Liste der Studien und `macula info` zum Ordner sagen, warum.</translation>
    </message>
    <message>
        <source>The study could not be opened.</source>
        <translation>Die Studie konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Run `macula info` on the folder to find out what is wrong with it.</source>
        <translation>Rufen Sie `macula info` zum Ordner auf, um zu erfahren, was daran falsch ist.</translation>
    </message>
    <message>
        <source>Nothing of the series can be seen.</source>
        <translation>Von der Serie ist nichts zu sehen.</translation>
    </message>
    <message>
        <source>Choose another preset or clip.</source>
        <translation>Wählen Sie eine andere Voreinstellung oder einen anderen Beschnitt.</translation>
    </message>
    <message>
        <source>The only volume.</source>
        <translation>Das einzige Volumen.</translation>
    </message>
    <message>
        <source>No folder was given: this is the built-in phantom.</source>
        <translation>Kein Ordner wurde angegeben: das ist das eingebaute Phantom.</translation>
    </message>
    <message>
        <source>1 file was left out; macula info says why.</source>
        <translation>1 Datei wurde weggelassen; macula info sagt, warum.</translation>
    </message>
    <message>
        <source>%1 files were left out; macula info says why.</source>
        <translation>%1 Dateien wurden weggelassen; macula info sagt, warum.</translation>
    </message>
    <message>
        <source>Patient %1</source>
        <translation>Patient %1</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Series without a number</source>
        <translation>Serie ohne Nummer</translation>
    </message>
    <message>
        <source>no images</source>
        <translation>keine Bilder</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>%1 images</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>1 series</source>
        <translation>1 Serie</translation>
    </message>
    <message>
        <source>%1 series</source>
        <translation>%1 Serien</translation>
    </message>
    <message>
        <source>1 volume</source>
        <translation>1 Volumen</translation>
    </message>
    <message>
        <source>%1 volumes</source>
        <translation>%1 Volumen</translation>
    </message>
    <message>
        <source>1 object</source>
        <translation>1 Objekt</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <translation>%1 Objekte</translation>
    </message>
    <message>
        <source>Stack %1</source>
        <translation>Stapel %1</translation>
    </message>
    <message>
        <source>1 file left out</source>
        <translation>1 Datei weggelassen</translation>
    </message>
    <message>
        <source>%1 files left out</source>
        <translation>%1 Dateien weggelassen</translation>
    </message>
    <message>
        <source>The values were not counted.</source>
        <translation>Die Werte wurden nicht gezählt.</translation>
    </message>
    <message>
        <source>There is not enough memory to count the values.</source>
        <translation>Es ist nicht genug Speicher da, um die Werte zu zählen.</translation>
    </message>
    <message>
        <source>Close other programs, and open the study again.</source>
        <translation>Schließen Sie andere Programme, und öffnen Sie die Studie noch einmal.</translation>
    </message>
    <message>
        <source>The file of settings is damaged.</source>
        <translation>Die Datei der Einstellungen ist beschädigt.</translation>
    </message>
    <message>
        <source>The usual settings are taken; what you set next is saved, and the damaged file is kept.</source>
        <translation>Es gelten die üblichen Einstellungen; was Sie als Nächstes einstellen, wird gespeichert, und die beschädigte Datei bleibt erhalten.</translation>
    </message>
    <message>
        <source>The settings could not be saved: their folder cannot be made.</source>
        <translation>Die Einstellungen konnten nicht gespeichert werden: ihr Ordner kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>The window cannot show Vulkan pictures.</source>
        <translation>Das Fenster kann keine Vulkan-Bilder zeigen.</translation>
    </message>
    <message>
        <source>Install a Vulkan driver for this display.</source>
        <translation>Installieren Sie einen Vulkan-Treiber für diese Anzeige.</translation>
    </message>
    <message>
        <source>This kind of display cannot show Vulkan pictures.</source>
        <translation>Diese Art von Anzeige kann keine Vulkan-Bilder zeigen.</translation>
    </message>
    <message>
        <source>Use an X11 or a Wayland display, or `macula render`.</source>
        <translation>Verwenden Sie eine X11- oder Wayland-Anzeige, oder `macula render`.</translation>
    </message>
    <message>
        <source>Camera %1 of the path is none: %2</source>
        <translation>Kamera %1 der Fahrt ist keine: %2</translation>
    </message>
    <message>
        <source>That part of the clip is not there any more.</source>
        <translation>Diesen Teil des Beschnitts gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>Take hold of another one.</source>
        <translation>Fassen Sie einen anderen.</translation>
    </message>
    <message>
        <source>The depth of the cut is not a number.</source>
        <translation>Die Tiefe des Schnitts ist keine Zahl.</translation>
    </message>
    <message>
        <source>Draw around what is to be removed, in one go.</source>
        <translation>Umfahren Sie in einem Zug, was entfernt werden soll.</translation>
    </message>
    <message>
        <source>The outline has fewer than three points.</source>
        <translation>Der Umriss hat weniger als drei Punkte.</translation>
    </message>
    <message>
        <source>The outline has too many points.</source>
        <translation>Der Umriss hat zu viele Punkte.</translation>
    </message>
    <message>
        <source>A point of the outline is no number.</source>
        <translation>Ein Punkt des Umrisses ist keine Zahl.</translation>
    </message>
    <message>
        <source>The outline encloses nothing.</source>
        <translation>Der Umriss umschließt nichts.</translation>
    </message>
    <message>
        <source>the preview is not sharp enough: %1 of %2 steps</source>
        <translation>die Vorschau ist nicht scharf genug: %1 von %2 Schritten</translation>
    </message>
    <message>
        <source>An error could not be reported.</source>
        <translation>Ein Fehler konnte nicht gemeldet werden.</translation>
    </message>
    <message>
        <source>Waiting for the graphics device to let go of the window.</source>
        <translation>Das Grafikgerät gibt das Fenster noch nicht frei.</translation>
    </message>
    <message>
        <source>The model's name says no format.</source>
        <translation>Der Name des Modells nennt kein Format.</translation>
    </message>
    <message>
        <source>The name says no format that splats alone are written in.</source>
        <translation>Der Name nennt kein Format, in dem Splats allein geschrieben werden.</translation>
    </message>
    <message>
        <source>The model has learnt nothing yet that training could go on with.</source>
        <translation>Das Modell hat noch nichts gelernt, womit das Training weitergehen könnte.</translation>
    </message>
    <message>
        <source>Wait until the picture converges, or save it as .ply, .spz or .glb.</source>
        <translation>Warten Sie, bis das Bild besser wird, oder speichern Sie es als .ply, .spz oder .glb.</translation>
    </message>
    <message>
        <source>The model could not be written.</source>
        <translation>Das Modell konnte nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Writing the model</source>
        <translation>Das Modell wird gespeichert</translation>
    </message>
    <message>
        <source>What goes on learning needs linear colours.</source>
        <translation>Was weiterlernt, braucht lineare Farben.</translation>
    </message>
    <message>
        <source>Save it as .ply, .spz or .glb, or without colours as displayed.</source>
        <translation>Speichern Sie es als .ply, .spz oder .glb, oder ohne Farben wie gezeigt.</translation>
    </message>
    <message>
        <source>There is not enough memory to write the model.</source>
        <translation>Es ist nicht genug Speicher da, um das Modell zu speichern.</translation>
    </message>
    <message>
        <source>Give --overwrite to replace it, or choose another name.</source>
        <translation>Geben Sie --overwrite an, um sie zu ersetzen, oder wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Two outputs have the same name.</source>
        <translation>Zwei Ausgaben haben denselben Namen.</translation>
    </message>
    <message>
        <source>Give each a name of its own.</source>
        <translation>Geben Sie jeder einen eigenen Namen.</translation>
    </message>
    <message>
        <source>The small picture was not drawn.</source>
        <translation>Das kleine Bild wurde nicht gezeichnet.</translation>
    </message>
    <message>
        <source>There is not enough memory for small pictures of presets.</source>
        <translation>Für kleine Bilder der Voreinstellungen ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>There is not enough memory for small pictures.</source>
        <translation>Für kleine Bilder ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>There is not enough memory for both pictures.</source>
        <translation>Für beide Bilder ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>There is not enough memory for these pictures.</source>
        <translation>Für diese Bilder ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Every voxel of the series is padding: there is nothing to draw.</source>
        <translation>Jedes Voxel der Serie ist Füllwert: es gibt nichts zu zeichnen.</translation>
    </message>
    <message>
        <source>Open another series.</source>
        <translation>Öffnen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>A sequence cannot have that many pictures.</source>
        <translation>So viele Bilder kann eine Folge nicht haben.</translation>
    </message>
    <message>
        <source>Take 1 to %1.</source>
        <translation>Nehmen Sie 1 bis %1.</translation>
    </message>
    <message>
        <source>The way of the camera has no view.</source>
        <translation>Die Kamerafahrt hat keine Ansicht.</translation>
    </message>
    <message>
        <source>Add one first.</source>
        <translation>Fügen Sie zuerst eine hinzu.</translation>
    </message>
    <message>
        <source>The folder for the pictures cannot be made.</source>
        <translation>Der Ordner für die Bilder kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>The folder holds pictures of another sequence.</source>
        <translation>Der Ordner enthält Bilder einer anderen Folge.</translation>
    </message>
    <message>
        <source>Choose an empty folder, or make a new one.</source>
        <translation>Wählen Sie einen leeren Ordner, oder legen Sie einen neuen an.</translation>
    </message>
    <message>
        <source>Drawing pictures</source>
        <translation>Bilder werden gezeichnet</translation>
    </message>
    <message>
        <source>Choose another presentation state.</source>
        <translation>Wählen Sie einen anderen Presentation State.</translation>
    </message>
    <message>
        <source>The clip of the presentation state leaves nothing of this series.</source>
        <translation>Der Beschnitt des Presentation State lässt von dieser Serie nichts übrig.</translation>
    </message>
    <message>
        <source>The clip of the presentation state is of more planes than six.</source>
        <translation>Der Beschnitt des Presentation State hat mehr als sechs Ebenen.</translation>
    </message>
    <message>
        <source>A presentation state refers to DICOM images with identifiers and a frame of reference, and this series has none.</source>
        <translation>Ein Presentation State bezieht sich auf DICOM-Bilder mit Kennungen und einem Koordinatensystem, und diese Serie hat keine.</translation>
    </message>
    <message>
        <source>The window is a curve; others get a straight one.</source>
        <translation>Die Fensterung ist eine Kurve; andere Programme erhalten eine gerade.</translation>
    </message>
    <message>
        <source>Others cannot show an average, and show the preset instead.</source>
        <translation>Andere Programme können keinen Mittelwert zeigen und zeigen stattdessen die Voreinstellung.</translation>
    </message>
    <message>
        <source>Opacities that depend on edges (gradients) are for Macula alone.</source>
        <translation>Deckkräfte, die von Kanten (Gradienten) abhängen, gelten nur für Macula.</translation>
    </message>
    <message>
        <source>Others know no steep matter: they show what is halfway between flat and steep.</source>
        <translation>Andere Programme kennen keine steile Materie: sie zeigen, was in der Mitte zwischen flacher und steiler liegt.</translation>
    </message>
    <message>
        <source>Others have no path tracing: of the lights they get the strongest, and how bright the rest is.</source>
        <translation>Andere Programme haben keine Pfadverfolgung: von der Beleuchtung erhalten sie das stärkste Licht und wie hell der Rest ist.</translation>
    </message>
    <message>
        <source>Others show the table, which is left out here.</source>
        <translation>Andere Programme zeigen den Tisch, der hier weggelassen ist.</translation>
    </message>
    <message>
        <source>Others show segments that are hidden here.</source>
        <translation>Andere Programme zeigen Segmente, die hier ausgeblendet sind.</translation>
    </message>
    <message>
        <source>Others show what is cut off with scissors here.</source>
        <translation>Andere Programme zeigen, was hier mit der Schere abgeschnitten ist.</translation>
    </message>
    <message>
        <source>Others show boxes, corners and balls that are cut out here.</source>
        <translation>Andere Programme zeigen Quader, Ecken und Kugeln, die hier herausgeschnitten sind.</translation>
    </message>
    <message>
        <source>Grey faces and shadows of what is cut off are for Macula alone.</source>
        <translation>Graue Flächen und Schatten des Abgeschnittenen gelten nur für Macula.</translation>
    </message>
    <message>
        <source>There is no picture yet to make a presentation state of.</source>
        <translation>Es gibt noch kein Bild für einen Presentation State.</translation>
    </message>
    <message>
        <source>Wait until the study is shown.</source>
        <translation>Warten Sie, bis die Studie gezeigt wird.</translation>
    </message>
    <message>
        <source>The view is too large to be kept as a whole: Macula too shows only what others show.</source>
        <translation>Die Ansicht ist zu groß, um ganz bewahrt zu werden: auch Macula zeigt nur, was andere zeigen.</translation>
    </message>
    <message>
        <source>The clock of this machine shows an earlier time than an opening of a study that is stored, so nothing was deleted for its age.</source>
        <translation>Die Uhr dieses Rechners zeigt eine frühere Zeit, als beim Öffnen einer Studie gespeichert wurde. Deshalb wurde nichts seines Alters wegen gelöscht.</translation>
    </message>
    <message>
        <source>The clock of this machine is so far ahead of the last opening that every stored study would be deleted for its age; those that were not old then were kept.</source>
        <translation>Die Uhr dieses Rechners ist der letzten Öffnung so weit voraus, dass jede gespeicherte Studie ihres Alters wegen gelöscht würde; was damals nicht alt war, wurde behalten.</translation>
    </message>
    <message>
        <source>Set the clock.</source>
        <translation>Stellen Sie die Uhr.</translation>
    </message>
    <message>
        <source>Where it is right, run `macula sessions purge --unused-days N --trust-clock`.</source>
        <translation>Wenn sie stimmt, rufen Sie `macula sessions purge --unused-days N --trust-clock` auf.</translation>
    </message>
    <message>
        <source>Where the clock is right there is nothing to do: from tomorrow on it is believed.</source>
        <translation>Wenn die Uhr stimmt, ist nichts zu tun: ab morgen wird ihr geglaubt.</translation>
    </message>
    <message>
        <source>To delete now, run `macula sessions purge --unused-days N --trust-clock`.</source>
        <translation>Um jetzt zu löschen, rufen Sie `macula sessions purge --unused-days N --trust-clock` auf.</translation>
    </message>
    <message>
        <source>Without patient and study, the second volume and segmentations are not found again.</source>
        <translation>Ohne Patient und Studie werden das zweite Volumen und Segmentierungen nicht wiedergefunden.</translation>
    </message>
    <message>
        <source>The key that makes identifiers unreadable for others could not be kept.</source>
        <translation>Der Schlüssel, der Kennungen für andere unlesbar macht, konnte nicht aufbewahrt werden.</translation>
    </message>
    <message>
        <source>Check free space and permissions of that folder.</source>
        <translation>Prüfen Sie freien Platz und Rechte dieses Ordners.</translation>
    </message>
    <message>
        <source>The file with the key that makes identifiers unreadable for others cannot be read, or holds none.</source>
        <translation>Die Datei mit dem Schlüssel, der Kennungen für andere unlesbar macht, kann nicht gelesen werden oder enthält keinen.</translation>
    </message>
    <message>
        <source>Bring it back from a backup, or remove it: then a new one is made.</source>
        <translation>Holen Sie sie aus einer Sicherung zurück, oder löschen Sie sie: dann wird ein neuer gemacht.</translation>
    </message>
    <message>
        <source>The colours of this projection are shown as greys.</source>
        <translation>Die Farben dieser Projektion werden als Graustufen gezeigt.</translation>
    </message>
    <message>
        <source>The presentation state does not say of which thickness its opacities are; 1 mm is taken.</source>
        <translation>Der Presentation State sagt nicht, für welche Dicke seine Deckkräfte gelten; 1 mm wird angenommen.</translation>
    </message>
    <message>
        <source>Highlights are not drawn.</source>
        <translation>Glanzlichter werden nicht gezeichnet.</translation>
    </message>
    <message>
        <source>Surfaces are shaded from both sides.</source>
        <translation>Flächen werden von beiden Seiten schattiert.</translation>
    </message>
    <message>
        <source>Light comes from the viewer, and not from where the presentation state has it.</source>
        <translation>Das Licht kommt vom Betrachter und nicht von dort, wo der Presentation State es hat.</translation>
    </message>
    <message>
        <source>The picture is larger than that of the presentation state, whose middle is not where it looks at.</source>
        <translation>Das Bild ist größer als das des Presentation State, dessen Mitte nicht sein Blickpunkt ist.</translation>
    </message>
    <message>
        <source>What a newer Macula has written cannot be read; the picture is as others show it.</source>
        <translation>Was ein neueres Macula geschrieben hat, kann nicht gelesen werden; das Bild ist, wie andere es zeigen.</translation>
    </message>
    <message>
        <source>The presentation state is of other images of this series, such as another phase.</source>
        <translation>Der Presentation State ist von anderen Bildern dieser Serie, etwa einer anderen Phase.</translation>
    </message>
    <message>
        <source>Choose the volume of these images, or another presentation state.</source>
        <translation>Wählen Sie das Volumen dieser Bilder oder einen anderen Presentation State.</translation>
    </message>
    <message>
        <source>The presentation state is of other images of this series, too, or of a part of these alone.</source>
        <translation>Der Presentation State ist auch von anderen Bildern dieser Serie oder nur von einem Teil dieser Bilder.</translation>
    </message>
    <message>
        <source>The presentation state is of another series.</source>
        <translation>Der Presentation State ist von einer anderen Serie.</translation>
    </message>
    <message>
        <source>Open that series, or choose another presentation state.</source>
        <translation>Öffnen Sie diese Serie, oder wählen Sie einen anderen Presentation State.</translation>
    </message>
    <message>
        <source>What lies before or behind the depth of its view is shown, too.</source>
        <translation>Auch was vor oder hinter der Tiefe seiner Ansicht liegt, wird gezeigt.</translation>
    </message>
    <message>
        <source>The measurement was stopped.</source>
        <translation>Die Messung wurde angehalten.</translation>
    </message>
    <message>
        <source>Measuring this machine</source>
        <translation>Dieser Rechner wird gemessen</translation>
    </message>
    <message>
        <source>There is not enough memory to measure.</source>
        <translation>Zum Messen ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>It is of another patient.</source>
        <translation>Sie ist von einem anderen Patienten.</translation>
    </message>
    <message>
        <source>It has no frames.</source>
        <translation>Sie hat keine Einzelbilder.</translation>
    </message>
    <message>
        <source>It lies in another coordinate system (frame of reference) than this volume.</source>
        <translation>Sie liegt in einem anderen Koordinatensystem (Frame of Reference) als dieses Volumen.</translation>
    </message>
    <message>
        <source>Nothing says that it lies in the coordinate system of this volume.</source>
        <translation>Nichts sagt, dass sie im Koordinatensystem dieses Volumens liegt.</translation>
    </message>
    <message>
        <source>It was drawn on another series of this coordinate system.</source>
        <translation>Sie wurde auf einer anderen Serie dieses Koordinatensystems gezeichnet.</translation>
    </message>
    <message>
        <source>Reading %1 segmentations</source>
        <translation>%1 Segmentierungen werden gelesen</translation>
    </message>
    <message>
        <source>Reading segmentations was cancelled.</source>
        <translation>Das Lesen der Segmentierungen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is not enough memory to read the segmentations.</source>
        <translation>Es ist nicht genug Speicher da, um die Segmentierungen zu lesen.</translation>
    </message>
    <message>
        <source>It was drawn on other voxels than those of this volume; the nearest voxel is shown.</source>
        <translation>Sie wurde auf anderen Voxeln als denen dieses Volumens gezeichnet; das nächste Voxel wird gezeigt.</translation>
    </message>
    <message>
        <source>It has fractions; what is half or more is shown as the segment.</source>
        <translation>Sie hat Anteile; was die Hälfte oder mehr ist, wird als Segment gezeigt.</translation>
    </message>
    <message>
        <source>%1 of its voxels lie outside of this volume, and are not counted.</source>
        <translation>%1 ihrer Voxel liegen außerhalb dieses Volumens und werden nicht gezählt.</translation>
    </message>
    <message>
        <source>No voxel of it lies in this volume.</source>
        <translation>Kein Voxel davon liegt in diesem Volumen.</translation>
    </message>
    <message>
        <source>Hiding segments</source>
        <translation>Segmente werden ausgeblendet</translation>
    </message>
    <message>
        <source>Hiding segments was cancelled.</source>
        <translation>Das Ausblenden der Segmente wurde abgebrochen.</translation>
    </message>
    <message>
        <source>one segment alone</source>
        <translation>ein Segment allein</translation>
    </message>
    <message>
        <source>some segments alone</source>
        <translation>einige Segmente allein</translation>
    </message>
    <message>
        <source>a segment left out</source>
        <translation>ein Segment weggelassen</translation>
    </message>
    <message>
        <source>some segments left out</source>
        <translation>einige Segmente weggelassen</translation>
    </message>
    <message>
        <source>There is not enough memory to hide segments.</source>
        <translation>Es ist nicht genug Speicher da, um Segmente auszublenden.</translation>
    </message>
    <message>
        <source>Close other programs, or hide fewer. The picture and what is chosen stay as before.</source>
        <translation>Schließen Sie andere Programme, oder blenden Sie weniger aus. Bild und Auswahl bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>Stored sessions: %1 studies and %2 volumes were not opened for %3 days, and deleted.</source>
        <translation>Gespeicherte Sitzungen: %1 Studien und %2 Volumen wurden %3 Tage lang nicht geöffnet und gelöscht.</translation>
    </message>
    <message>
        <source>What was not opened for long could not be deleted.</source>
        <translation>Was lange nicht geöffnet wurde, konnte nicht gelöscht werden.</translation>
    </message>
    <message>
        <source>The name has letters that cannot be read.</source>
        <translation>Der Name hat Buchstaben, die nicht gelesen werden können.</translation>
    </message>
    <message>
        <source>Type it anew.</source>
        <translation>Geben Sie ihn neu ein.</translation>
    </message>
    <message>
        <source>The name has letters that cannot be seen.</source>
        <translation>Der Name hat Buchstaben, die nicht zu sehen sind.</translation>
    </message>
    <message>
        <source>Type it anew, without pasting.</source>
        <translation>Geben Sie ihn neu ein, ohne einzufügen.</translation>
    </message>
    <message>
        <source>The preset needs a name.</source>
        <translation>Die Voreinstellung braucht einen Namen.</translation>
    </message>
    <message>
        <source>Type one.</source>
        <translation>Geben Sie einen ein.</translation>
    </message>
    <message>
        <source>The name is too long.</source>
        <translation>Der Name ist zu lang.</translation>
    </message>
    <message>
        <source>Use at most %1 letters.</source>
        <translation>Nehmen Sie höchstens %1 Buchstaben.</translation>
    </message>
    <message>
        <source>It is too large.</source>
        <translation>Sie ist zu groß.</translation>
    </message>
    <message>
        <source>The preset cannot be kept: %1</source>
        <translation>Die Voreinstellung kann nicht behalten werden: %1</translation>
    </message>
    <message>
        <source>There is a preset of that name already.</source>
        <translation>Eine Voreinstellung dieses Namens gibt es schon.</translation>
    </message>
    <message>
        <source>There are too many presets of your own.</source>
        <translation>Es gibt zu viele eigene Voreinstellungen.</translation>
    </message>
    <message>
        <source>Delete some first.</source>
        <translation>Löschen Sie zuerst einige.</translation>
    </message>
    <message>
        <source>The camera cannot be kept: a part of it would be lost.</source>
        <translation>Die Kamera kann nicht behalten werden: ein Teil von ihr ginge verloren.</translation>
    </message>
    <message>
        <source>Keep the curve alone.</source>
        <translation>Behalten Sie nur die Kurve.</translation>
    </message>
    <message>
        <source>What is seen cannot be kept: %1</source>
        <translation>Das Gezeigte kann nicht behalten werden: %1</translation>
    </message>
    <message>
        <source>A built-in preset cannot be renamed.</source>
        <translation>Eine eingebaute Voreinstellung kann nicht umbenannt werden.</translation>
    </message>
    <message>
        <source>Save a copy of it.</source>
        <translation>Speichern Sie eine Kopie davon.</translation>
    </message>
    <message>
        <source>There is no preset to save yet.</source>
        <translation>Es gibt noch keine Voreinstellung zu speichern.</translation>
    </message>
    <message>
        <source>There is nothing to be seen yet.</source>
        <translation>Es ist noch nichts zu sehen.</translation>
    </message>
    <message>
        <source>The preset is gone.</source>
        <translation>Die Voreinstellung gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>Choose another one.</source>
        <translation>Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>There is not enough memory to read the presets.</source>
        <translation>Es ist nicht genug Speicher da, um die Voreinstellungen zu lesen.</translation>
    </message>
    <message>
        <source>A window is kept under a name.</source>
        <translation>Eine Fensterung wird unter einem Namen behalten.</translation>
    </message>
    <message>
        <source>Type one, such as Kidney.</source>
        <translation>Geben Sie einen ein, zum Beispiel Niere.</translation>
    </message>
    <message>
        <source>There are %1 windows of your own already.</source>
        <translation>Es gibt schon %1 eigene Fensterungen.</translation>
    </message>
    <message>
        <source>Remove one first.</source>
        <translation>Entfernen Sie zuerst eine.</translation>
    </message>
    <message>
        <source>There is not enough memory to keep windows.</source>
        <translation>Es ist nicht genug Speicher da, um Fensterungen zu behalten.</translation>
    </message>
    <message>
        <source>at most %1 bytes</source>
        <translation>höchstens %1 Bytes</translation>
    </message>
    <message>
        <source>namedClips: expected another thing.</source>
        <translation>namedClips: hier wird anderes erwartet.</translation>
    </message>
    <message>
        <source>A list of at most %1 clips.</source>
        <translation>Eine Liste mit höchstens %1 Beschnitten.</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>Hiding voxels</source>
        <translation>Voxel werden ausgeblendet</translation>
    </message>
    <message>
        <source>Hiding voxels was cancelled.</source>
        <translation>Das Ausblenden der Voxel wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is not enough memory to hide parts of the volume.</source>
        <translation>Es ist nicht genug Speicher da, um Teile des Volumens auszublenden.</translation>
    </message>
    <message>
        <source>Close other programs, or hide less. The picture and what is chosen stay as before.</source>
        <translation>Schließen Sie andere Programme, oder blenden Sie weniger aus. Bild und Auswahl bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>Cutting with the scissors</source>
        <translation>Mit der Schere wird geschnitten</translation>
    </message>
    <message>
        <source>The cut was cancelled.</source>
        <translation>Der Schnitt wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Draw the outline around less, or keep the inside with Shift.</source>
        <translation>Umfahren Sie weniger, oder behalten Sie mit Umschalt das Innere.</translation>
    </message>
    <message>
        <source>There is not enough memory to cut this volume with the scissors.</source>
        <translation>Es ist nicht genug Speicher da, um dieses Volumen mit der Schere zu schneiden.</translation>
    </message>
    <message>
        <source>Close other programs, or clip with a box, planes or a ball.</source>
        <translation>Schließen Sie andere Programme, oder beschneiden Sie mit einem Quader, Ebenen oder einer Kugel.</translation>
    </message>
    <message>
        <source>cut with scissors</source>
        <translation>mit der Schere geschnitten</translation>
    </message>
    <message>
        <source>There is no image.</source>
        <translation>Es gibt kein Bild.</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of the series.</source>
        <translation>Für ein Bild der Serie ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>The view keeps or hides segments; here they change nothing.</source>
        <translation>Die Ansicht behält Segmente oder blendet sie aus; hier ändern sie nichts.</translation>
    </message>
    <message>
        <source>The preset is made for other units than those of the series.</source>
        <translation>Die Voreinstellung ist für andere Einheiten gemacht als die der Serie.</translation>
    </message>
    <message>
        <source>no images so far</source>
        <translation>bisher keine Bilder</translation>
    </message>
    <message>
        <source>1 image so far</source>
        <translation>bisher 1 Bild</translation>
    </message>
    <message>
        <source>%1 images so far</source>
        <translation>bisher %1 Bilder</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>There is no display to open a window on, or it does not answer.</source>
        <translation>Es gibt keine Anzeige für ein Fenster, oder sie antwortet nicht.</translation>
    </message>
    <message>
        <source>Set DISPLAY or WAYLAND_DISPLAY, or use `macula render`, which needs none.</source>
        <translation>Setzen Sie DISPLAY oder WAYLAND_DISPLAY, oder verwenden Sie `macula render`, das keine braucht.</translation>
    </message>
    <message>
        <source>The presentation state is of other images.</source>
        <translation>Der Presentation State ist von anderen Bildern.</translation>
    </message>
    <message>
        <source>Open the series of these images, or choose another presentation state.</source>
        <translation>Öffnen Sie die Serie dieser Bilder, oder wählen Sie einen anderen Presentation State.</translation>
    </message>
    <message>
        <source>No DICOM study is open.</source>
        <translation>Es ist keine DICOM-Studie offen.</translation>
    </message>
    <message>
        <source>Open the series of the presentation state first.</source>
        <translation>Öffnen Sie zuerst die Serie des Presentation States.</translation>
    </message>
    <message>
        <source>It has no window for its first image here.</source>
        <translation>Er hat hier kein Fenster für sein erstes Bild.</translation>
    </message>
    <message>
        <source>Its window is a table of values (VOI LUT), which is not shown.</source>
        <translation>Sein Fenster ist eine Tabelle von Werten (VOI LUT), die nicht gezeigt wird.</translation>
    </message>
    <message>
        <source>Its window is of other values than those of the volume, and is not shown.</source>
        <translation>Sein Fenster ist von anderen Werten als denen des Volumens und wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>It has several windows; that of its first image is shown.</source>
        <translation>Er hat mehrere Fenster; das seines ersten Bildes wird gezeigt.</translation>
    </message>
    <message>
        <source>It is of some of the images alone; the others are shown in the same way.</source>
        <translation>Er gilt nur für einen Teil der Bilder; die anderen werden ebenso gezeigt.</translation>
    </message>
    <message>
        <source>It asks for the true size on the screen, which is not shown: slices fit their pane.</source>
        <translation>Er verlangt die wahre Größe auf dem Bildschirm, die nicht gezeigt wird: Schichten füllen ihr Feld.</translation>
    </message>
    <message>
        <source>It asks for a fixed magnification, which is not shown: slices fit their pane.</source>
        <translation>Er verlangt eine feste Vergrößerung, die nicht gezeigt wird: Schichten füllen ihr Feld.</translation>
    </message>
    <message>
        <source>Where its images lie is not known: the slices stay where they are.</source>
        <translation>Wo seine Bilder liegen, ist nicht bekannt: die Schichten bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>It turns or mirrors its images, which slices here never do: its part of the image is not shown.</source>
        <translation>Er dreht oder spiegelt seine Bilder, was Schichten hier nie tun: sein Bildausschnitt wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>Its part of the image lies beside the volume, and is not shown.</source>
        <translation>Sein Bildausschnitt liegt neben dem Volumen und wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>View of slices</source>
        <translation>Ansicht von Schichten</translation>
    </message>
    <message>
        <source>Macula does not show presentation states of this kind.</source>
        <translation>Macula zeigt Presentation States dieser Art nicht.</translation>
    </message>
    <message>
        <source>The images that it is of are no volume.</source>
        <translation>Die Bilder dazu sind kein Volumen.</translation>
    </message>
    <message>
        <source>The series that it is of belongs to another patient.</source>
        <translation>Die Serie dazu gehört zu einem anderen Patienten.</translation>
    </message>
    <message>
        <source>The series that it is of is not in this folder.</source>
        <translation>Die Serie dazu ist nicht in diesem Ordner.</translation>
    </message>
    <message>
        <source>coloured segments</source>
        <translation>farbige Segmente</translation>
    </message>
    <message>
        <source>with a second volume</source>
        <translation>mit einem zweiten Volumen</translation>
    </message>
    <message>
        <source>registration doubtful</source>
        <translation>Registrierung zweifelhaft</translation>
    </message>
    <message>
        <source>of ANOTHER PATIENT</source>
        <translation>von einem ANDEREN PATIENTEN</translation>
    </message>
    <message>
        <source>perhaps of another patient</source>
        <translation>vielleicht von einem anderen Patienten</translation>
    </message>
    <message>
        <source>with CT</source>
        <translation>mit CT</translation>
    </message>
    <message>
        <source>with MR</source>
        <translation>mit MR</translation>
    </message>
    <message>
        <source>with PT</source>
        <translation>mit PT</translation>
    </message>
    <message>
        <source>with NM</source>
        <translation>mit NM</translation>
    </message>
    <message>
        <source>There is not enough memory to colour segments.</source>
        <translation>Es ist nicht genug Speicher da, um Segmente zu färben.</translation>
    </message>
    <message>
        <source>Close other programs, or colour fewer. The picture and what is chosen stay as before.</source>
        <translation>Schließen Sie andere Programme, oder färben Sie weniger. Bild und Auswahl bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>Colouring segments was cancelled.</source>
        <translation>Das Färben der Segmente wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Colouring segments</source>
        <translation>Segmente werden gefärbt</translation>
    </message>
    <message>
        <source>More than 255 segments of different colours cannot be shown in 3D.</source>
        <translation>Mehr als 255 Segmente verschiedener Farben können in 3D nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>Colour fewer of them, or give some the same colour.</source>
        <translation>Färben Sie weniger davon, oder geben Sie einigen dieselbe Farbe.</translation>
    </message>
    <message>
        <source>Others show no colours of segments.</source>
        <translation>Andere zeigen keine Farben von Segmenten.</translation>
    </message>
    <message>
        <source>Others show the study without the second volume.</source>
        <translation>Andere zeigen die Studie ohne das zweite Volumen.</translation>
    </message>
    <message>
        <source>Presentation state</source>
        <translation>Presentation State</translation>
    </message>
</context>
<context>
    <name>labels</name>
    <message>
        <source>series %1: %2</source>
        <translation>Serie %1: %2</translation>
    </message>
    <message>
        <source>series without a number: %1</source>
        <translation>Serie ohne Nummer: %1</translation>
    </message>
    <message>
        <source>Series %1: %2</source>
        <translation>Serie %1: %2</translation>
    </message>
    <message>
        <source>Series without a number: %1</source>
        <translation>Serie ohne Nummer: %1</translation>
    </message>
    <message>
        <source>%1: this is no image.</source>
        <translation>%1: das ist kein Bild.</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geboren %1</translation>
    </message>
</context>
<context>
    <name>pieces</name>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>superior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>low</source>
        <translation>gering</translation>
    </message>
    <message>
        <source>original axial</source>
        <translation>originale axiale</translation>
    </message>
    <message>
        <source>original</source>
        <translation>originale</translation>
    </message>
    <message>
        <source>axial</source>
        <translation>axiale</translation>
    </message>
    <message>
        <source>without interpolated slices and</source>
        <translation>ohne interpolierte Schichten und</translation>
    </message>
    <message>
        <source>it did not become whole</source>
        <translation>sie wurde nicht vollständig</translation>
    </message>
    <message>
        <source>something unforeseen happened</source>
        <translation>etwas Unvorhergesehenes ist geschehen</translation>
    </message>
    <message>
        <source>Computed radiography image</source>
        <translation>Speicherfolienaufnahme (CR)</translation>
    </message>
    <message>
        <source>Digital X-ray image</source>
        <translation>digitale Röntgenaufnahme</translation>
    </message>
    <message>
        <source>Digital X-ray image, unprocessed</source>
        <translation>digitale Röntgenaufnahme, unverarbeitet</translation>
    </message>
    <message>
        <source>Mammography image</source>
        <translation>Mammographie</translation>
    </message>
    <message>
        <source>Mammography image, unprocessed</source>
        <translation>Mammographie, unverarbeitet</translation>
    </message>
    <message>
        <source>Intra-oral X-ray image</source>
        <translation>intraorale Röntgenaufnahme</translation>
    </message>
    <message>
        <source>X-ray angiographic image</source>
        <translation>angiographische Röntgenaufnahme</translation>
    </message>
    <message>
        <source>Enhanced X-ray angiographic image</source>
        <translation>angiographische Röntgenaufnahme (Enhanced)</translation>
    </message>
    <message>
        <source>X-ray radiofluoroscopic image</source>
        <translation>Durchleuchtung</translation>
    </message>
    <message>
        <source>Enhanced X-ray radiofluoroscopic image</source>
        <translation>Durchleuchtung (Enhanced)</translation>
    </message>
    <message>
        <source>Visible light image</source>
        <translation>Aufnahme in sichtbarem Licht</translation>
    </message>
    <message>
        <source>Ultrasound clip</source>
        <translation>Ultraschallsequenz</translation>
    </message>
    <message>
        <source>Ultrasound image</source>
        <translation>Ultraschallbild</translation>
    </message>
    <message>
        <source>Key object selection</source>
        <translation>Auswahl wichtiger Bilder (Key Object Selection)</translation>
    </message>
    <message>
        <source>Structured report</source>
        <translation>strukturierter Befund (Structured Report)</translation>
    </message>
    <message>
        <source>Presentation state of a 3D view</source>
        <translation>Presentation State einer 3D-Ansicht</translation>
    </message>
    <message>
        <source>Presentation state</source>
        <translation>Presentation State</translation>
    </message>
    <message>
        <source>Waveform</source>
        <translation>Kurve (Waveform)</translation>
    </message>
    <message>
        <source>Raw data</source>
        <translation>Rohdaten</translation>
    </message>
    <message>
        <source>Spatial registration</source>
        <translation>räumliche Registrierung</translation>
    </message>
    <message>
        <source>Spatial fiducials</source>
        <translation>räumliche Marker</translation>
    </message>
    <message>
        <source>Deformable spatial registration</source>
        <translation>elastische räumliche Registrierung</translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation>Segmentierung</translation>
    </message>
    <message>
        <source>Surface segmentation</source>
        <translation>Oberflächensegmentierung</translation>
    </message>
    <message>
        <source>Tractography</source>
        <translation>Traktographie</translation>
    </message>
    <message>
        <source>Label map segmentation</source>
        <translation>Label-Map-Segmentierung</translation>
    </message>
    <message>
        <source>Real world value mapping</source>
        <translation>Zuordnung von Real World Values</translation>
    </message>
    <message>
        <source>MR spectroscopy</source>
        <translation>MR-Spektroskopie</translation>
    </message>
    <message>
        <source>PDF document</source>
        <translation>PDF-Dokument</translation>
    </message>
    <message>
        <source>CDA document</source>
        <translation>CDA-Dokument</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Radiotherapy structure set</source>
        <translation>Strahlentherapie-Strukturen (RTSTRUCT)</translation>
    </message>
    <message>
        <source>Radiotherapy plan</source>
        <translation>Bestrahlungsplan</translation>
    </message>
    <message>
        <source>Radiotherapy object</source>
        <translation>Strahlentherapie-Objekt</translation>
    </message>
    <message>
        <source>Object of unknown kind</source>
        <translation>Objekt unbekannter Art</translation>
    </message>
    <message>
        <source>SUV by body weight</source>
        <translation>SUV nach Körpergewicht</translation>
    </message>
    <message>
        <source>Units of Bq/mL</source>
        <translation>die Einheit Bq/mL</translation>
    </message>
    <message>
        <source>correction for decay and attenuation</source>
        <translation>die Korrektur für Zerfall und Schwächung</translation>
    </message>
    <message>
        <source>time of the scan</source>
        <translation>die Aufnahmezeit</translation>
    </message>
    <message>
        <source>plausible time between injection and scan</source>
        <translation>eine plausible Zeit zwischen Injektion und Aufnahme</translation>
    </message>
    <message>
        <source>a RadionuclideTotalDose in Bq that fits PatientWeight</source>
        <translation>eine RadionuclideTotalDose in Bq, die zu PatientWeight passt</translation>
    </message>
    <message>
        <source>0 for the first camera</source>
        <translation>0 für die erste Kamera</translation>
    </message>
    <message>
        <source>a later time than that of the camera before</source>
        <translation>eine spätere Zeit als die der Kamera davor</translation>
    </message>
    <message>
        <source>an eye, a target and an upright that make a camera</source>
        <translation>ein Auge, ein Ziel und eine Richtung nach oben, die eine Kamera ergeben</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>ein Name</translation>
    </message>
    <message>
        <source>a rotation and a shift, row by row</source>
        <translation>eine Drehung und eine Verschiebung, Zeile für Zeile</translation>
    </message>
    <message>
        <source>the digest of a series</source>
        <translation>die Prüfsumme einer Serie</translation>
    </message>
    <message>
        <source>a direction, not all zeros</source>
        <translation>eine Richtung, nicht nur Nullen</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>Zahlenpaare</translation>
    </message>
    <message>
        <source>"inside" or "outside"</source>
        <translation>„inside“ oder „outside“</translation>
    </message>
    <message>
        <source>a camera, and an outline that encloses something</source>
        <translation>eine Kamera und ein Umriss, der etwas umschließt</translation>
    </message>
    <message>
        <source>64 hexadecimal digits</source>
        <translation>64 hexadezimale Ziffern</translation>
    </message>
    <message>
        <source>a direction perpendicular to "right"</source>
        <translation>eine Richtung senkrecht zu „right“</translation>
    </message>
    <message>
        <source>"distance", "angle" or "ellipse"</source>
        <translation>„distance“, „angle“ oder „ellipse“</translation>
    </message>
    <message>
        <source>an object, { … }</source>
        <translation>ein Objekt, { … }</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>ein Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>lower-case letters, digits and hyphens</source>
        <translation>Kleinbuchstaben, Ziffern und Bindestriche</translation>
    </message>
    <message>
        <source>two ascending numbers</source>
        <translation>zwei aufsteigende Zahlen</translation>
    </message>
    <message>
        <source>there are more than six planes</source>
        <translation>es sind mehr als sechs Ebenen</translation>
    </message>
    <message>
        <source>the box has no size</source>
        <translation>der Quader hat keine Größe</translation>
    </message>
    <message>
        <source>the axes of the box are not at right angles</source>
        <translation>die Achsen des Quaders stehen nicht senkrecht</translation>
    </message>
    <message>
        <source>a plane has no direction</source>
        <translation>eine Ebene hat keine Richtung</translation>
    </message>
    <message>
        <source>the corner has no direction</source>
        <translation>die Ecke hat keine Richtung</translation>
    </message>
    <message>
        <source>the ball has no size</source>
        <translation>die Kugel hat keine Größe</translation>
    </message>
    <message>
        <source>there is no segmentation to mask with</source>
        <translation>es gibt keine Segmentierung zum Ausblenden</translation>
    </message>
    <message>
        <source>the window of its faces has no width</source>
        <translation>die Fensterung seiner Flächen hat keine Breite</translation>
    </message>
    <message>
        <source>RGB, HSV, Lab, CIELAB, Diverging or Step</source>
        <translation>RGB, HSV, Lab, CIELAB, Diverging oder Step</translation>
    </message>
    <message>
        <source>a continuous colour map: categories cannot be drawn as one</source>
        <translation>eine stetige Farbtabelle: Kategorien können nicht so gezeichnet werden</translation>
    </message>
    <message>
        <source>a linear scale</source>
        <translation>eine lineare Skala</translation>
    </message>
    <message>
        <source>colours at two values or more</source>
        <translation>Farben bei zwei oder mehr Werten</translation>
    </message>
    <message>
        <source>the interpolation, 0 for nearest or 1 for linear</source>
        <translation>die Interpolation, 0 für nächste oder 1 für linear</translation>
    </message>
    <message>
        <source>whether it is shaded, 0 or 1</source>
        <translation>ob schattiert wird, 0 oder 1</translation>
    </message>
    <message>
        <source>the diffuse coefficient, 0 or above</source>
        <translation>der diffuse Koeffizient, 0 oder mehr</translation>
    </message>
    <message>
        <source>the ambient coefficient, 0 or above</source>
        <translation>der ambiente Koeffizient, 0 oder mehr</translation>
    </message>
    <message>
        <source>the specular coefficient, 0 or above</source>
        <translation>der spiegelnde Koeffizient, 0 oder mehr</translation>
    </message>
    <message>
        <source>the specular power, 0 or above</source>
        <translation>der spiegelnde Exponent, 0 oder mehr</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>has no points</source>
        <translation>hat keine Punkte</translation>
    </message>
    <message>
        <source>has a value that is too large</source>
        <translation>hat einen zu großen Wert</translation>
    </message>
    <message>
        <source>has something in it that is no usable number, or too many of them</source>
        <translation>enthält etwas, das keine brauchbare Zahl ist, oder zu viele davon</translation>
    </message>
    <message>
        <source>scalar opacity (line 7)</source>
        <translation>Die Deckkraft (Zeile 7)</translation>
    </message>
    <message>
        <source>gradient opacity (line 8)</source>
        <translation>Die Gradienten-Deckkraft (Zeile 8)</translation>
    </message>
    <message>
        <source>colour (line 9)</source>
        <translation>Die Farbe (Zeile 9)</translation>
    </message>
    <message>
        <source>holds a number that cannot be read</source>
        <translation>enthält eine Zahl, die nicht gelesen werden kann</translation>
    </message>
    <message>
        <source>has a key without a value, or a value without a key</source>
        <translation>hat einen Schlüssel ohne Wert oder einen Wert ohne Schlüssel</translation>
    </message>
    <message>
        <source>"LINEAR", "LINEAR_EXACT" or "SIGMOID"</source>
        <translation>„LINEAR“, „LINEAR_EXACT“ oder „SIGMOID“</translation>
    </message>
    <message>
        <source>a table of greys</source>
        <translation>eine Tabelle von Grauwerten</translation>
    </message>
    <message>
        <source>a displayed area that is none</source>
        <translation>einen Bildausschnitt, der keiner ist</translation>
    </message>
    <message>
        <source>an unreadable list of frames</source>
        <translation>eine unlesbare Liste von Einzelbildern</translation>
    </message>
    <message>
        <source>annotations</source>
        <translation>Anmerkungen</translation>
    </message>
    <message>
        <source>a shutter</source>
        <translation>eine Blende</translation>
    </message>
    <message>
        <source>a subtraction of images</source>
        <translation>eine Subtraktion von Bildern</translation>
    </message>
    <message>
        <source>an overlay</source>
        <translation>ein Overlay</translation>
    </message>
    <message>
        <source>Presentation state of slices</source>
        <translation>Presentation State von Schichten</translation>
    </message>
    <message>
        <source>be found</source>
        <translation>gefunden werden</translation>
    </message>
    <message>
        <source>be reached through its software</source>
        <translation>über seine Software erreicht werden</translation>
    </message>
    <message>
        <source>begin a picture</source>
        <translation>ein Bild beginnen</translation>
    </message>
    <message>
        <source>begin a session</source>
        <translation>eine Sitzung beginnen</translation>
    </message>
    <message>
        <source>begin to show pictures</source>
        <translation>beginnen, Bilder zu zeigen</translation>
    </message>
    <message>
        <source>end the session</source>
        <translation>die Sitzung beenden</translation>
    </message>
    <message>
        <source>find its place</source>
        <translation>seinen Ort finden</translation>
    </message>
    <message>
        <source>follow the eyes</source>
        <translation>den Augen folgen</translation>
    </message>
    <message>
        <source>keep pictures of that size</source>
        <translation>Bilder dieser Größe halten</translation>
    </message>
    <message>
        <source>lend a picture</source>
        <translation>ein Bild leihen</translation>
    </message>
    <message>
        <source>lend its pictures</source>
        <translation>seine Bilder leihen</translation>
    </message>
    <message>
        <source>name its controls</source>
        <translation>seine Bedienelemente nennen</translation>
    </message>
    <message>
        <source>show a picture to each eye</source>
        <translation>jedem Auge ein Bild zeigen</translation>
    </message>
    <message>
        <source>show a picture</source>
        <translation>ein Bild zeigen</translation>
    </message>
    <message>
        <source>stop showing pictures</source>
        <translation>aufhören, Bilder zu zeigen</translation>
    </message>
    <message>
        <source>take a picture back</source>
        <translation>ein Bild zurücknehmen</translation>
    </message>
    <message>
        <source>tell how it shows pictures</source>
        <translation>sagen, wie es Bilder zeigt</translation>
    </message>
    <message>
        <source>tell its name</source>
        <translation>seinen Namen sagen</translation>
    </message>
    <message>
        <source>tell the name of its software</source>
        <translation>den Namen seiner Software sagen</translation>
    </message>
    <message>
        <source>tell what hands do</source>
        <translation>sagen, was Hände tun</translation>
    </message>
    <message>
        <source>tell what it does</source>
        <translation>sagen, was es tut</translation>
    </message>
    <message>
        <source>tell what it offers</source>
        <translation>sagen, was es kann</translation>
    </message>
    <message>
        <source>tell what its lenses show</source>
        <translation>sagen, was seine Linsen zeigen</translation>
    </message>
    <message>
        <source>tell when it shows a picture</source>
        <translation>sagen, wann es ein Bild zeigt</translation>
    </message>
    <message>
        <source>tell where hands are</source>
        <translation>sagen, wo Hände sind</translation>
    </message>
    <message>
        <source>tell where hands point</source>
        <translation>sagen, wohin Hände zeigen</translation>
    </message>
    <message>
        <source>tell where the eyes are</source>
        <translation>sagen, wo die Augen sind</translation>
    </message>
    <message>
        <source>tell whether it sees hands</source>
        <translation>sagen, ob es Hände sieht</translation>
    </message>
    <message>
        <source>tell which Vulkan it needs</source>
        <translation>sagen, welches Vulkan es braucht</translation>
    </message>
    <message>
        <source>tell which graphics device it is connected to</source>
        <translation>sagen, an welche Grafikkarte es angeschlossen ist</translation>
    </message>
    <message>
        <source>tell which pictures it takes</source>
        <translation>sagen, welche Bilder es nimmt</translation>
    </message>
    <message>
        <source>tell which spaces it knows</source>
        <translation>sagen, welche Räume es kennt</translation>
    </message>
    <message>
        <source>use controllers</source>
        <translation>Controller verwenden</translation>
    </message>
    <message>
        <source>start Vulkan</source>
        <translation>Vulkan starten</translation>
    </message>
    <message>
        <source>open its graphics device</source>
        <translation>seine Grafikkarte öffnen</translation>
    </message>
    <message>
        <source>go on</source>
        <translation>weitermachen</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>antworten</translation>
    </message>
    <message>
        <source>be felt in a hand</source>
        <translation>in der Hand zu spüren sein</translation>
    </message>
    <message>
        <source>follow hands</source>
        <translation>Händen folgen</translation>
    </message>
    <message>
        <source>show a panel</source>
        <translation>eine Tafel zeigen</translation>
    </message>
    <message>
        <source>take a panel back</source>
        <translation>eine Tafel zurücknehmen</translation>
    </message>
</context>
<context>
    <name>session</name>
    <message>
        <source>Stored sessions could not be opened.</source>
        <translation>Gespeicherte Sitzungen konnten nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the folder or a file in it is read-only.</source>
        <translation>Sitzungen können nicht gespeichert werden: der Ordner oder eine Datei darin ist schreibgeschützt.</translation>
    </message>
    <message>
        <source>Make the folder writable for you, or choose another one.</source>
        <translation>Machen Sie den Ordner für sich beschreibbar, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the disk is full.</source>
        <translation>Sitzungen können nicht gespeichert werden: der Datenträger ist voll.</translation>
    </message>
    <message>
        <source>Free some space on that disk; what was stored before is unharmed.</source>
        <translation>Schaffen Sie Platz auf dem Datenträger; früher Gespeichertes ist unversehrt.</translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the drive cannot lock files.</source>
        <translation>Sitzungen können nicht gespeichert werden: das Laufwerk kann keine Dateien sperren.</translation>
    </message>
    <message>
        <source>Choose a folder on a local disk, or have locks switched on for that network drive.</source>
        <translation>Wählen Sie einen Ordner auf einem lokalen Datenträger, oder lassen Sie Sperren für das Netzlaufwerk einschalten.</translation>
    </message>
    <message>
        <source>Stored sessions are in use by another program.</source>
        <translation>Gespeicherte Sitzungen werden von einem anderen Programm benutzt.</translation>
    </message>
    <message>
        <source>Wait a moment and try again, or close other windows of Macula.</source>
        <translation>Warten Sie kurz und versuchen Sie es noch einmal, oder schließen Sie andere Fenster von Macula.</translation>
    </message>
    <message>
        <source>The file of stored sessions is damaged.</source>
        <translation>Die Datei der gespeicherten Sitzungen ist beschädigt.</translation>
    </message>
    <message>
        <source>Close all windows of Macula and start it again: it rescues what can be read, and keeps the file.</source>
        <translation>Schließen Sie alle Fenster von Macula und starten Sie es neu: es rettet, was lesbar ist, und behält die Datei.</translation>
    </message>
    <message>
        <source>Stored sessions were written by a newer version of Macula.</source>
        <translation>Gespeicherte Sitzungen stammen von einer neueren Version von Macula.</translation>
    </message>
    <message>
        <source>Use that version, or choose another folder. Nothing was changed.</source>
        <translation>Verwenden Sie diese Version, oder wählen Sie einen anderen Ordner. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The folder for sessions holds files of another program.</source>
        <translation>Der Ordner für Sitzungen enthält Dateien eines anderen Programms.</translation>
    </message>
    <message>
        <source>Choose an empty folder, or one that Macula made. Nothing was changed.</source>
        <translation>Wählen Sie einen leeren Ordner oder einen von Macula. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The disk reported an error while sessions were read or stored.</source>
        <translation>Der Datenträger meldete beim Lesen oder Speichern von Sitzungen einen Fehler.</translation>
    </message>
    <message>
        <source>Have the disk checked, or choose a folder on another one.</source>
        <translation>Lassen Sie den Datenträger prüfen, oder wählen Sie einen Ordner auf einem anderen.</translation>
    </message>
    <message>
        <source>There is not enough memory to read or store sessions.</source>
        <translation>Es ist nicht genug Speicher da, um Sitzungen zu lesen oder zu speichern.</translation>
    </message>
    <message>
        <source>Close other programs and try again.</source>
        <translation>Schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>A stored model is damaged; it was set aside.</source>
        <translation>Ein gespeichertes Modell ist beschädigt; es wurde beiseitegelegt.</translation>
    </message>
    <message>
        <source>Nothing has to be done: the model is learnt anew.</source>
        <translation>Es ist nichts zu tun: das Modell wird neu gelernt.</translation>
    </message>
    <message>
        <source>A model is larger than all that may be stored.</source>
        <translation>Ein Modell ist größer als alles, was gespeichert werden darf.</translation>
    </message>
    <message>
        <source>Raise the limit for stored models.</source>
        <translation>Erhöhen Sie die Grenze für gespeicherte Modelle.</translation>
    </message>
    <message>
        <source>The stored model is no longer there.</source>
        <translation>Das gespeicherte Modell ist nicht mehr da.</translation>
    </message>
    <message>
        <source>A stored setting is damaged; it was set aside.</source>
        <translation>Eine gespeicherte Einstellung ist beschädigt; sie wurde beiseitegelegt.</translation>
    </message>
    <message>
        <source>Make the setting once more.</source>
        <translation>Machen Sie die Einstellung noch einmal.</translation>
    </message>
    <message>
        <source>What is to be stored is no valid setting.</source>
        <translation>Was gespeichert werden soll, ist keine gültige Einstellung.</translation>
    </message>
    <message>
        <source>Check that it has a name of at most 200 bytes, and is a JSON object of at most 8 MB and 64 levels.</source>
        <translation>Prüfen Sie, ob es einen Namen von höchstens 200 Bytes hat und ein JSON-Objekt von höchstens 8 MB und 64 Ebenen ist.</translation>
    </message>
    <message>
        <source>The data are deleted, but traces may remain in a file that another program is reading.</source>
        <translation>Die Daten sind gelöscht, aber Spuren können in einer Datei bleiben, die ein anderes Programm liest.</translation>
    </message>
    <message>
        <source>Close other windows of Macula and delete the same once more.</source>
        <translation>Schließen Sie andere Fenster von Macula, und löschen Sie dasselbe noch einmal.</translation>
    </message>
    <message>
        <source>Stored sessions were brought to the format of this version; older ones cannot read them now.</source>
        <translation>Gespeicherte Sitzungen wurden in das Format dieser Version gebracht; ältere können sie nun nicht lesen.</translation>
    </message>
    <message>
        <source>Other users of this computer may be able to read stored sessions.</source>
        <translation>Andere Benutzer dieses Rechners können gespeicherte Sitzungen vielleicht lesen.</translation>
    </message>
</context>
<context>
    <name>pipeline</name>
    <message>
        <source>There is no Vulkan driver on this computer, so nothing can be rendered.</source>
        <translation>Auf diesem Rechner ist kein Vulkan-Treiber, also kann nichts gezeichnet werden.</translation>
    </message>
    <message>
        <source>Install the driver of the graphics card, or, to render on the CPU, the Debian/Ubuntu package mesa-vulkan-drivers: sudo apt install mesa-vulkan-drivers</source>
        <translation>Installieren Sie den Treiber der Grafikkarte oder, um auf dem Prozessor zu zeichnen, das Debian-/Ubuntu-Paket mesa-vulkan-drivers: sudo apt install mesa-vulkan-drivers</translation>
    </message>
    <message>
        <source>The Vulkan driver of this computer does not offer %1.</source>
        <translation>Der Vulkan-Treiber dieses Rechners bietet %1 nicht.</translation>
    </message>
    <message>
        <source>Update the graphics driver.</source>
        <translation>Aktualisieren Sie den Grafiktreiber.</translation>
    </message>
    <message>
        <source>The device %1 cannot be used: %2.</source>
        <translation>Das Gerät %1 kann nicht verwendet werden: %2.</translation>
    </message>
    <message>
        <source>Update its driver, or choose another device.</source>
        <translation>Aktualisieren Sie seinen Treiber, oder wählen Sie ein anderes Gerät.</translation>
    </message>
    <message>
        <source>The graphics device stopped responding %1 times within a minute.</source>
        <translation>Das Grafikgerät hat innerhalb einer Minute %1-mal nicht mehr geantwortet.</translation>
    </message>
    <message>
        <source>Update the graphics driver, or choose another device: `macula devices` lists them, --device or MACULA_DEVICE takes one. The processor (llvmpipe) is slow but always there.</source>
        <translation>Aktualisieren Sie den Grafiktreiber, oder wählen Sie ein anderes Gerät: `macula devices` zählt sie auf, --device oder MACULA_DEVICE nimmt eines. Der Prozessor (llvmpipe) ist langsam, aber immer da.</translation>
    </message>
    <message>
        <source>The %1 does not fit on the device %2: it needs %3, and the device allows %4.</source>
        <translation>%1 passt nicht auf das Gerät %2: nötig sind %3, und das Gerät erlaubt %4.</translation>
    </message>
    <message>
        <source>Open a smaller series, or choose a device with more memory by MACULA_DEVICE.</source>
        <translation>Öffnen Sie eine kleinere Serie, oder wählen Sie mit MACULA_DEVICE ein Gerät mit mehr Speicher.</translation>
    </message>
    <message>
        <source>The device %1 cannot draw in this window.</source>
        <translation>Das Gerät %1 kann nicht in diesem Fenster zeichnen.</translation>
    </message>
    <message>
        <source>Choose the device that drives the display by MACULA_DEVICE.</source>
        <translation>Wählen Sie mit MACULA_DEVICE das Gerät, das die Anzeige treibt.</translation>
    </message>
    <message>
        <source>Could not %1: the computer&apos;s memory is full.</source>
        <translation>Fehler (%1): der Speicher des Rechners ist voll.</translation>
    </message>
    <message>
        <source>Could not %1: the graphics memory is full.</source>
        <translation>Fehler (%1): der Grafikspeicher ist voll.</translation>
    </message>
    <message>
        <source>Close other programs that draw in 3D, open a smaller series, or choose another device with MACULA_DEVICE.</source>
        <translation>Schließen Sie andere Programme, die in 3D zeichnen, öffnen Sie eine kleinere Serie, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>Could not %1: the graphics device stopped responding and was reset.</source>
        <translation>Fehler (%1): das Grafikgerät hat nicht mehr geantwortet und wurde zurückgesetzt.</translation>
    </message>
    <message>
        <source>Try again. If this comes back, update the graphics driver, or choose another device with MACULA_DEVICE.</source>
        <translation>Versuchen Sie es noch einmal. Wenn das wieder vorkommt, aktualisieren Sie den Grafiktreiber, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>Could not %1: the window system took the window away.</source>
        <translation>Fehler (%1): das Fenstersystem hat das Fenster weggenommen.</translation>
    </message>
    <message>
        <source>Open the window again.</source>
        <translation>Öffnen Sie das Fenster noch einmal.</translation>
    </message>
    <message>
        <source>Could not %1: the graphics driver reports %2.</source>
        <translation>Fehler (%1): der Grafiktreiber meldet %2.</translation>
    </message>
    <message>
        <source>Update the graphics driver, or choose another device with MACULA_DEVICE.</source>
        <translation>Aktualisieren Sie den Grafiktreiber, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>There is no room on the device for the peripheral model to learn.</source>
        <translation>Auf dem Gerät ist kein Platz, auf dem das periphere Modell lernen kann.</translation>
    </message>
    <message>
        <source>The stored peripheral model cannot be gone on with.</source>
        <translation>Mit dem gespeicherten peripheren Modell kann nicht weitergemacht werden.</translation>
    </message>
    <message>
        <source>Finding points</source>
        <translation>Punkte werden gesucht</translation>
    </message>
    <message>
        <source>Finding outlines</source>
        <translation>Umrisse werden gesucht</translation>
    </message>
    <message>
        <source>Tracing views</source>
        <translation>Ansichten werden verfolgt</translation>
    </message>
    <message>
        <source>Lighting views</source>
        <translation>Ansichten werden beleuchtet</translation>
    </message>
    <message>
        <source>What is visible takes %1 MiB and only %2 MiB can be had: %3 of %4 visible blocks (%5 %) are shown %6 voxels as one along each edge.</source>
        <translation>Das Sichtbare braucht %1 MiB, und nur %2 MiB sind zu haben: %3 von %4 sichtbaren Blöcken (%5 %) werden mit je %6 Voxeln als einem entlang jeder Kante gezeigt.</translation>
    </message>
    <message>
        <source>What is visible takes %1 MiB and only %2 MiB can be had: %3 of %4 visible blocks (%5 %) are shown %6 voxels as one along each edge or less.</source>
        <translation>Das Sichtbare braucht %1 MiB, und nur %2 MiB sind zu haben: %3 von %4 sichtbaren Blöcken (%5 %) werden mit je %6 Voxeln als einem entlang jeder Kante oder weniger gezeigt.</translation>
    </message>
    <message>
        <source>Show less of the volume by another preset or a clip, or use a device with more memory.</source>
        <translation>Zeigen Sie mit einer anderen Voreinstellung oder einem Beschnitt weniger vom Volumen, oder verwenden Sie ein Gerät mit mehr Speicher.</translation>
    </message>
    <message>
        <source>Show less of the volume by another preset or a clip, or allow more memory for voxels.</source>
        <translation>Zeigen Sie mit einer anderen Voreinstellung oder einem Beschnitt weniger vom Volumen, oder erlauben Sie mehr Speicher für Voxel.</translation>
    </message>
    <message>
        <source>Show less of the volume by another preset or a clip: this device&apos;s buffers hold no more.</source>
        <translation>Zeigen Sie mit einer anderen Voreinstellung oder einem Beschnitt weniger vom Volumen: Die Puffer dieses Geräts fassen nicht mehr.</translation>
    </message>
    <message>
        <source>There is nothing to trace yet.</source>
        <translation>Es gibt noch nichts zu verfolgen.</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>A volume of %1 million voxels is more than can be traced.</source>
        <translation>Ein Volumen von %1 Millionen Voxeln ist mehr, als verfolgt werden kann.</translation>
    </message>
    <message>
        <source>Open a smaller series.</source>
        <translation>Öffnen Sie eine kleinere Serie.</translation>
    </message>
    <message>
        <source>The preset was stretched to this volume: its %1 to %2 are drawn at %3 to %4, %5.</source>
        <translation>Die Voreinstellung wurde auf dieses Volumen gestreckt: ihre %1 bis %2 liegen bei %3 bis %4, %5.</translation>
    </message>
    <message>
        <source>the 2nd and 98th percentile of the foreground</source>
        <translation>dem 2. und 98. Perzentil des Vordergrunds</translation>
    </message>
    <message>
        <source>the smallest and largest value</source>
        <translation>dem kleinsten und größten Wert</translation>
    </message>
    <message>
        <source>Compare brightness and colours only within this volume.</source>
        <translation>Vergleichen Sie Helligkeit und Farben nur innerhalb dieses Volumens.</translation>
    </message>
    <message>
        <source>The file is no valid JSON.</source>
        <translation>Die Datei ist kein gültiges JSON.</translation>
    </message>
    <message>
        <source>The file is no valid JSON from %1 on.</source>
        <translation>Die Datei ist ab %1 kein gültiges JSON.</translation>
    </message>
    <message>
        <source>Look for a missing comma, quote or bracket there or just before.</source>
        <translation>Suchen Sie dort oder kurz davor nach einem fehlenden Komma, Anführungszeichen oder einer Klammer.</translation>
    </message>
    <message>
        <source>The key %1 is missing.</source>
        <translation>Der Schlüssel %1 fehlt.</translation>
    </message>
    <message>
        <source>The key %1 is unknown.</source>
        <translation>Der Schlüssel %1 ist unbekannt.</translation>
    </message>
    <message>
        <source>%1 is not as expected.</source>
        <translation>%1 ist nicht wie erwartet.</translation>
    </message>
    <message>
        <source>Expected %1.</source>
        <translation>Erwartet: %1.</translation>
    </message>
    <message>
        <source>Add it.</source>
        <translation>Fügen Sie ihn hinzu.</translation>
    </message>
    <message>
        <source>Known here: %1.</source>
        <translation>Hier bekannt: %1.</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a number not below %1</source>
        <translation>eine Zahl nicht unter %1</translation>
    </message>
    <message>
        <source>a number not above %1</source>
        <translation>eine Zahl nicht über %1</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>a list of %1 entries</source>
        <translation>eine Liste mit %1 Einträgen</translation>
    </message>
    <message>
        <source>a list of %1 to %2 entries</source>
        <translation>eine Liste mit %1 bis %2 Einträgen</translation>
    </message>
    <message>
        <source>The file is nested too deeply at %1.</source>
        <translation>Die Datei ist bei %1 zu tief geschachtelt.</translation>
    </message>
    <message>
        <source>Look for numbers that are too large.</source>
        <translation>Suchen Sie nach Zahlen, die zu groß sind.</translation>
    </message>
    <message>
        <source>Correct the preset.</source>
        <translation>Berichtigen Sie die Voreinstellung.</translation>
    </message>
    <message>
        <source>The preset's opacity points are missing, not finite, or not sorted by value.</source>
        <translation>Die Deckkraftpunkte der Voreinstellung fehlen, sind nicht endlich oder nicht nach Wert sortiert.</translation>
    </message>
    <message>
        <source>The preset's colour points are missing, not finite, or not sorted by value.</source>
        <translation>Die Farbpunkte der Voreinstellung fehlen, sind nicht endlich oder nicht nach Wert sortiert.</translation>
    </message>
    <message>
        <source>The preset's gradient opacity points are not finite or not sorted by value.</source>
        <translation>Die Punkte der Gradienten-Deckkraft der Voreinstellung sind nicht endlich oder nicht nach Wert sortiert.</translation>
    </message>
    <message>
        <source>An opacity of the preset, a midpoint or a sharpness lies outside 0 to 1.</source>
        <translation>Eine Deckkraft der Voreinstellung, ein Mittelpunkt oder eine Schärfe liegt außerhalb von 0 bis 1.</translation>
    </message>
    <message>
        <source>A colour of the preset, a midpoint or a sharpness lies outside 0 to 1.</source>
        <translation>Eine Farbe der Voreinstellung, ein Mittelpunkt oder eine Schärfe liegt außerhalb von 0 bis 1.</translation>
    </message>
    <message>
        <source>The preset's unit distance must be above 0 mm.</source>
        <translation>Die Bezugsdicke der Voreinstellung muss über 0 mm liegen.</translation>
    </message>
    <message>
        <source>The preset's density must be 0 or above.</source>
        <translation>Die Dichte der Voreinstellung muss 0 oder mehr sein.</translation>
    </message>
    <message>
        <source>The preset's albedo must lie in 0 to 1.</source>
        <translation>Die Albedo der Voreinstellung muss in 0 bis 1 liegen.</translation>
    </message>
    <message>
        <source>The preset's scattering anisotropy must lie between -0.99 and 0.99.</source>
        <translation>Die Streuanisotropie der Voreinstellung muss zwischen -0,99 und 0,99 liegen.</translation>
    </message>
    <message>
        <source>The preset's surface weight or reflectance lies outside 0 to 1, or its roughness outside 0.1 to 1.</source>
        <translation>Gewicht oder Reflexionsgrad der Oberfläche liegen in der Voreinstellung nicht in 0 bis 1, oder ihre Rauheit nicht in 0,1 bis 1.</translation>
    </message>
    <message>
        <source>The preset's surface gradient must be above 0.</source>
        <translation>Der Gradient der Oberfläche muss in der Voreinstellung über 0 liegen.</translation>
    </message>
    <message>
        <source>The preset's gradient of steep matter must be above 0.</source>
        <translation>Der Gradient steiler Materie muss in der Voreinstellung über 0 liegen.</translation>
    </message>
    <message>
        <source>The preset's curves of steep matter need points of opacity and of colour, finite and sorted by value.</source>
        <translation>Die Kurven steiler Materie brauchen in der Voreinstellung Punkte der Deckkraft und der Farbe, endlich und nach Wert sortiert.</translation>
    </message>
    <message>
        <source>An opacity of the preset's steep matter, a colour, a midpoint or a sharpness lies outside 0 to 1.</source>
        <translation>Eine Deckkraft der steilen Materie der Voreinstellung, eine Farbe, ein Mittelpunkt oder eine Schärfe liegt nicht in 0 bis 1.</translation>
    </message>
    <message>
        <source>The preset's range to fit to the volume is empty.</source>
        <translation>Der Bereich der Voreinstellung, der an das Volumen angepasst wird, ist leer.</translation>
    </message>
    <message>
        <source>The preset has no range of values that could be fitted.</source>
        <translation>Die Voreinstellung hat keinen Wertebereich, der angepasst werden könnte.</translation>
    </message>
    <message>
        <source>Use it without fitting, or give it an effectiveRange.</source>
        <translation>Verwenden Sie sie ohne Anpassung, oder geben Sie ihr einen effectiveRange.</translation>
    </message>
    <message>
        <source>points sorted by x: not below %1</source>
        <translation>nach x sortierte Punkte: nicht unter %1</translation>
    </message>
    <message>
        <source>The clip is not usable: %1.</source>
        <translation>Der Beschnitt ist nicht brauchbar: %1.</translation>
    </message>
    <message>
        <source>Give six planes at most.</source>
        <translation>Geben Sie höchstens sechs Ebenen an.</translation>
    </message>
    <message>
        <source>Give a centre and positive half sizes in mm.</source>
        <translation>Geben Sie eine Mitte und positive halbe Größen in mm an.</translation>
    </message>
    <message>
        <source>Give three unit vectors.</source>
        <translation>Geben Sie drei Einheitsvektoren an.</translation>
    </message>
    <message>
        <source>Give its normal as a unit vector, and its distance in mm.</source>
        <translation>Geben Sie ihre Normale als Einheitsvektor an und ihren Abstand in mm.</translation>
    </message>
    <message>
        <source>Give three signs, such as L, A, S.</source>
        <translation>Geben Sie drei Seiten an, zum Beispiel L, A, S.</translation>
    </message>
    <message>
        <source>Give a centre and a positive radius in mm.</source>
        <translation>Geben Sie eine Mitte und einen positiven Radius in mm an.</translation>
    </message>
    <message>
        <source>Give one.</source>
        <translation>Geben Sie eine an.</translation>
    </message>
    <message>
        <source>Give a centre and a positive width.</source>
        <translation>Geben Sie eine Mitte und eine positive Breite an.</translation>
    </message>
    <message>
        <source>Give a centre, and a width above 0.</source>
        <translation>Geben Sie eine Mitte und eine Breite über 0 an.</translation>
    </message>
    <message>
        <source>%1 bounces cannot be traced.</source>
        <translation>%1 Streuungen können nicht verfolgt werden.</translation>
    </message>
    <message>
        <source>Choose 1 to %1.</source>
        <translation>Wählen Sie 1 bis %1.</translation>
    </message>
    <message>
        <source>The exposure is not usable.</source>
        <translation>Die Belichtung ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose a number above 0, up to %1.</source>
        <translation>Wählen Sie eine Zahl über 0, bis %1.</translation>
    </message>
    <message>
        <source>The strength of the lights is not usable.</source>
        <translation>Die Stärke der Beleuchtung ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>The diameter of the lens is not usable.</source>
        <translation>Der Durchmesser der Linse ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose a number from 0 to %1 mm.</source>
        <translation>Wählen Sie eine Zahl von 0 bis %1 mm.</translation>
    </message>
    <message>
        <source>The distance of what is sharp is not usable.</source>
        <translation>Die Entfernung des Scharfen ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose a number above 0, up to %1 mm.</source>
        <translation>Wählen Sie eine Zahl über 0, bis %1 mm.</translation>
    </message>
    <message>
        <source>Give 0 to %1 mm; 0 is none.</source>
        <translation>Geben Sie 0 bis %1 mm an; 0 ist keine.</translation>
    </message>
    <message>
        <source>Give a number above 0, up to %1 mm, or auto.</source>
        <translation>Geben Sie eine Zahl über 0, bis %1 mm, oder auto an.</translation>
    </message>
    <message>
        <source>The depth of the fog is not usable.</source>
        <translation>Die Tiefe des Nebels ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give %1 to %2 mm, or 0 for none.</source>
        <translation>Geben Sie %1 bis %2 mm an, oder 0 für keinen.</translation>
    </message>
    <message>
        <source>The middle of the picture shows nothing that a lens could be focused on.</source>
        <translation>Die Bildmitte zeigt nichts, worauf eine Linse scharf gestellt werden könnte.</translation>
    </message>
    <message>
        <source>Move the camera, or give the distance in mm of what is to be sharp: --focus-mm.</source>
        <translation>Bewegen Sie die Kamera, oder geben Sie die Entfernung dessen, was scharf sein soll, in mm an: --focus-mm.</translation>
    </message>
    <message>
        <source>The camera stands in what the middle of the picture shows.</source>
        <translation>Die Kamera steht in dem, was die Bildmitte zeigt.</translation>
    </message>
    <message>
        <source>Choose a number from 0 to %1.</source>
        <translation>Wählen Sie eine Zahl von 0 bis %1.</translation>
    </message>
    <message>
        <source>The rotation of the lights is not usable.</source>
        <translation>Die Drehung der Beleuchtung ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose an angle in degrees.</source>
        <translation>Wählen Sie einen Winkel in Grad.</translation>
    </message>
    <message>
        <source>The window is not usable.</source>
        <translation>Die Fensterung ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Projections show all of the volume.</source>
        <translation>Projektionen zeigen das ganze Volumen.</translation>
    </message>
    <message>
        <source>Choose another look.</source>
        <translation>Wählen Sie eine andere Darstellung.</translation>
    </message>
    <message>
        <source>Choose a smaller picture, or another device.</source>
        <translation>Wählen Sie ein kleineres Bild oder ein anderes Gerät.</translation>
    </message>
    <message>
        <source>A volume of more than 2147 million voxels cannot be masked.</source>
        <translation>In einem Volumen von mehr als 2147 Millionen Voxeln kann nichts ausgeblendet werden.</translation>
    </message>
    <message>
        <source>Show it without a mask.</source>
        <translation>Zeigen Sie es, ohne etwas auszublenden.</translation>
    </message>
    <message>
        <source>There is nothing to be seen.</source>
        <translation>Es ist nichts zu sehen.</translation>
    </message>
    <message>
        <source>Choose a preset that shows something of the series.</source>
        <translation>Wählen Sie eine Voreinstellung, die etwas von der Serie zeigt.</translation>
    </message>
    <message>
        <source>The state of the peripheral model is damaged: its parts do not belong together.</source>
        <translation>Der Zustand des peripheren Modells ist beschädigt: seine Teile gehören nicht zusammen.</translation>
    </message>
    <message>
        <source>Load it again, or have it learnt anew.</source>
        <translation>Laden Sie es noch einmal, oder lassen Sie es neu lernen.</translation>
    </message>
    <message>
        <source>There is no memory for the model.</source>
        <translation>Für das Modell ist kein Speicher da.</translation>
    </message>
    <message>
        <source>The model is too large for a glTF file.</source>
        <translation>Das Modell ist für eine glTF-Datei zu groß.</translation>
    </message>
    <message>
        <source>Write it as .ply instead.</source>
        <translation>Speichern Sie es stattdessen als .ply.</translation>
    </message>
    <message>
        <source>The model holds no splats.</source>
        <translation>Das Modell enthält keine Splats.</translation>
    </message>
    <message>
        <source>The model reaches farther than an SPZ file can say: 8 km from its origin.</source>
        <translation>Das Modell reicht weiter, als eine SPZ-Datei angeben kann: 8 km von seinem Ursprung.</translation>
    </message>
    <message>
        <source>Remove the splats that are so far away, or write a PLY.</source>
        <translation>Entfernen Sie die Splats, die so weit weg sind, oder speichern Sie eine PLY.</translation>
    </message>
    <message>
        <source>The model has %1 splats; an SPZ file holds at most %2.</source>
        <translation>Das Modell hat %1 Splats; eine SPZ-Datei fasst höchstens %2.</translation>
    </message>
    <message>
        <source>Write a PLY.</source>
        <translation>Speichern Sie eine PLY.</translation>
    </message>
    <message>
        <source>The model's splats are so much alike that its SPZ file could not be told from a false one.</source>
        <translation>Die Splats des Modells sind einander so ähnlich, dass seine SPZ-Datei nicht von einer falschen zu unterscheiden wäre.</translation>
    </message>
    <message>
        <source>Models are written as %1.</source>
        <translation>Modelle werden als %1 gespeichert.</translation>
    </message>
    <message>
        <source>Give the file one of these extensions.</source>
        <translation>Geben Sie der Datei eine dieser Endungen.</translation>
    </message>
    <message>
        <source>The device %1 does not offer %2.</source>
        <translation>Das Gerät %1 bietet %2 nicht.</translation>
    </message>
    <message>
        <source>Update its driver, or choose another device with MACULA_DEVICE.</source>
        <translation>Aktualisieren Sie seinen Treiber, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>There is no graphics device "%1".</source>
        <translation>Es gibt kein Grafikgerät „%1“.</translation>
    </message>
    <message>
        <source>Choose one by its number or a part of its name: %1</source>
        <translation>Wählen Sie eines nach seiner Nummer oder einem Teil seines Namens: %1</translation>
    </message>
    <message>
        <source>The graphics device stopped responding; the work begins anew on a new one.</source>
        <translation>Das Grafikgerät hat nicht mehr geantwortet; die Arbeit beginnt auf einem neuen noch einmal.</translation>
    </message>
    <message>
        <source>There is no second volume with a preset.</source>
        <translation>Es gibt kein zweites Volumen mit einer Voreinstellung.</translation>
    </message>
    <message>
        <source>Open a second volume, and choose a preset for it.</source>
        <translation>Öffnen Sie ein zweites Volumen, und wählen Sie eine Voreinstellung dafür.</translation>
    </message>
    <message>
        <source>Where the second volume lies is not usable.</source>
        <translation>Wo das zweite Volumen liegt, ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Register the two volumes again.</source>
        <translation>Registrieren Sie die beiden Volumen noch einmal.</translation>
    </message>
    <message>
        <source>The coloured segments are not of this volume.</source>
        <translation>Die farbigen Segmente gehören nicht zu diesem Volumen.</translation>
    </message>
    <message>
        <source>Show the segmentation again.</source>
        <translation>Zeigen Sie die Segmentierung noch einmal.</translation>
    </message>
    <message>
        <source>A coloured segment has no colour.</source>
        <translation>Ein farbiges Segment hat keine Farbe.</translation>
    </message>
    <message>
        <source>The colour of a segment is not usable.</source>
        <translation>Die Farbe eines Segments ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give red, green, blue and opacity from 0 to 1.</source>
        <translation>Geben Sie Rot, Grün, Blau und Deckkraft von 0 bis 1 an.</translation>
    </message>
    <message>
        <source>Of the second volume: %1</source>
        <translation>Zum zweiten Volumen: %1</translation>
    </message>
</context>
<context>
    <name>registration</name>
    <message>
        <source>Registration was cancelled.</source>
        <translation>Die Registrierung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Link the volumes by hand, or choose another series.</source>
        <translation>Koppeln Sie die Volumen von Hand, oder wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>One of the volumes has too few voxels to be registered.</source>
        <translation>Eines der Volumen hat zu wenige Voxel für eine Registrierung.</translation>
    </message>
    <message>
        <source>The volumes do not show enough of the same part of the body to be registered.</source>
        <translation>Die Volumen zeigen für eine Registrierung zu wenig vom selben Teil des Körpers.</translation>
    </message>
    <message>
        <source>A volume of fewer than three slices, rows or columns cannot be registered.</source>
        <translation>Ein Volumen mit weniger als drei Schichten, Zeilen oder Spalten kann nicht registriert werden.</translation>
    </message>
    <message>
        <source>One of the volumes has no values: there is nothing to register by.</source>
        <translation>Eines der Volumen hat keine Werte: es gibt nichts, wonach registriert werden kann.</translation>
    </message>
    <message>
        <source>One of the volumes has the same value everywhere: there is nothing to register by.</source>
        <translation>Eines der Volumen hat überall denselben Wert: es gibt nichts, wonach registriert werden kann.</translation>
    </message>
    <message>
        <source>Registering the second volume</source>
        <translation>Das zweite Volumen wird registriert</translation>
    </message>
    <message>
        <source>There is not enough memory to register the volumes.</source>
        <translation>Es ist nicht genug Speicher da, um die Volumen zu registrieren.</translation>
    </message>
    <message>
        <source>Close other programs, or link the volumes by hand.</source>
        <translation>Schließen Sie andere Programme, oder koppeln Sie die Volumen von Hand.</translation>
    </message>
</context>
<context>
    <name>presets</name>
    <message>
        <source>The %1 of the preset %2.</source>
        <translation>%1 der Voreinstellung %2.</translation>
    </message>
    <message>
        <source>Save the preset again in the program that it comes from.</source>
        <translation>Speichern Sie die Voreinstellung noch einmal in dem Programm, aus dem sie kommt.</translation>
    </message>
    <message>
        <source>The preset names the opacity table '%1', which is not in the file.</source>
        <translation>Die Voreinstellung nennt die Deckkrafttabelle „%1“, die nicht in der Datei ist.</translation>
    </message>
    <message>
        <source>Choose a built-in opacity table, or a 16-bit CLUT, and save the preset again.</source>
        <translation>Wählen Sie eine eingebaute Deckkrafttabelle oder eine CLUT mit 16 Bit, und speichern Sie die Voreinstellung noch einmal.</translation>
    </message>
    <message>
        <source>The shading '%1' is not known; the default shading was taken.</source>
        <translation>Die Schattierung „%1“ ist nicht bekannt; die übliche wurde genommen.</translation>
    </message>
    <message>
        <source>The filters of the preset are not applied.</source>
        <translation>Die Filter der Voreinstellung werden nicht angewendet.</translation>
    </message>
    <message>
        <source>A point of %1 has no usable %2.</source>
        <translation>Ein Punkt von %1 hat kein brauchbares %2.</translation>
    </message>
    <message>
        <source>Give it a number from %1 to %2.</source>
        <translation>Geben Sie ihm eine Zahl von %1 bis %2.</translation>
    </message>
    <message>
        <source>The %1 of the transfer function has %2 points.</source>
        <translation>%1 der Übertragungsfunktion hat %2 Punkte.</translation>
    </message>
    <message>
        <source>Give it 1 to %1 points.</source>
        <translation>Geben Sie ihr 1 bis %1 Punkte.</translation>
    </message>
    <message>
        <source>The version of the MITK transfer function is not known.</source>
        <translation>Die Version der MITK-Übertragungsfunktion ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Only version 1 can be read.</source>
        <translation>Nur Version 1 kann gelesen werden.</translation>
    </message>
    <message>
        <source>Opacities or colours outside 0 to 1 were clamped.</source>
        <translation>Deckkräfte oder Farben außerhalb von 0 bis 1 wurden begrenzt.</translation>
    </message>
    <message>
        <source>groups of %1 numbers</source>
        <translation>Gruppen von %1 Zahlen</translation>
    </message>
    <message>
        <source>The colour map has no opacities; a ramp from 0 at its first to 1 at its last colour was taken.</source>
        <translation>Die Farbtabelle hat keine Deckkräfte; eine Rampe von 0 bei der ersten bis 1 bei der letzten Farbe wurde genommen.</translation>
    </message>
    <message>
        <source>Only the first volume property, and its first component, are used.</source>
        <translation>Nur die erste Volumeneigenschaft und ihre erste Komponente werden verwendet.</translation>
    </message>
    <message>
        <source>The preset names the colour table '%1', which is not there.</source>
        <translation>Die Voreinstellung nennt die Farbtabelle „%1“, die fehlt.</translation>
    </message>
    <message>
        <source>Put the table beside the preset as NAME.plist, or save a 16-bit CLUT with the preset.</source>
        <translation>Legen Sie die Tabelle als NAME.plist neben die Voreinstellung, oder speichern Sie eine CLUT mit 16 Bit darin.</translation>
    </message>
    <message>
        <source>The preset file is empty.</source>
        <translation>Die Datei der Voreinstellung ist leer.</translation>
    </message>
    <message>
        <source>The file is no preset of a known format.</source>
        <translation>Die Datei ist keine Voreinstellung in einem bekannten Format.</translation>
    </message>
    <message>
        <source>Give a JSON preset, a .vp or presets.xml of 3D Slicer, a ParaView or VolView JSON, an XML of MITK, or a plist of Horos.</source>
        <translation>Wählen Sie eine JSON-Voreinstellung, eine .vp oder presets.xml von 3D Slicer, ein JSON von ParaView oder VolView, ein XML von MITK oder eine plist von Horos.</translation>
    </message>
    <message>
        <source>The file does not say what its values are; Hounsfield units of CT were assumed.</source>
        <translation>Die Datei sagt nicht, was ihre Werte sind; Hounsfield-Einheiten eines CT wurden angenommen.</translation>
    </message>
    <message>
        <source>The property list %1.</source>
        <translation>Die Property List %1.</translation>
    </message>
    <message>
        <source>Check that it is complete.</source>
        <translation>Prüfen Sie, ob sie vollständig ist.</translation>
    </message>
    <message>
        <source>The property list is in its binary form.</source>
        <translation>Die Property List ist in ihrer binären Form.</translation>
    </message>
    <message>
        <source>Convert it on a Mac: plutil -convert xml1 FILE.</source>
        <translation>Wandeln Sie sie auf einem Mac um: plutil -convert xml1 DATEI.</translation>
    </message>
    <message>
        <source>The file is no property list.</source>
        <translation>Die Datei ist keine Property List.</translation>
    </message>
    <message>
        <source>A .vp file of 3D Slicer has %1 lines; this has %2.</source>
        <translation>Eine .vp-Datei von 3D Slicer hat %1 Zeilen; diese hat %2.</translation>
    </message>
    <message>
        <source>Line %1 is not as expected.</source>
        <translation>Zeile %1 ist nicht wie erwartet.</translation>
    </message>
    <message>
        <source>The effective range cannot be read and was left out: "%1".</source>
        <translation>Der wirksame Bereich kann nicht gelesen werden und wurde weggelassen: „%1“.</translation>
    </message>
    <message>
        <source>The %1 of the preset %2 is no number from 0 to %3.</source>
        <translation>%1 der Voreinstellung %2 ist keine Zahl von 0 bis %3.</translation>
    </message>
    <message>
        <source>Correct it, or remove it.</source>
        <translation>Berichtigen oder entfernen Sie das.</translation>
    </message>
    <message>
        <source>The interpolation of the preset %1 is unknown.</source>
        <translation>Die Interpolation der Voreinstellung %1 ist unbekannt.</translation>
    </message>
    <message>
        <source>Use 0 for nearest or 1 for linear.</source>
        <translation>Nehmen Sie 0 für nächste oder 1 für linear.</translation>
    </message>
    <message>
        <source>The file holds too many presets.</source>
        <translation>Die Datei enthält zu viele Voreinstellungen.</translation>
    </message>
    <message>
        <source>Split it into files of at most %1.</source>
        <translation>Teilen Sie sie in Dateien mit höchstens %1.</translation>
    </message>
    <message>
        <source>The file holds no volume property of 3D Slicer.</source>
        <translation>Die Datei enthält keine Volumeneigenschaft von 3D Slicer.</translation>
    </message>
    <message>
        <source>Give a presets.xml, or an MRML scene with volume rendering.</source>
        <translation>Wählen Sie eine presets.xml oder eine MRML-Szene mit Volumen-Rendering.</translation>
    </message>
    <message>
        <source>The XML file declares entities, which no preset needs.</source>
        <translation>Die XML-Datei deklariert Entities, die keine Voreinstellung braucht.</translation>
    </message>
    <message>
        <source>Remove the DOCTYPE from the file, or take another one.</source>
        <translation>Entfernen Sie den DOCTYPE aus der Datei, oder nehmen Sie eine andere.</translation>
    </message>
    <message>
        <source>The file holds no XML element.</source>
        <translation>Die Datei enthält kein XML-Element.</translation>
    </message>
    <message>
        <source>The file is no valid XML around line %1.</source>
        <translation>Die Datei ist um Zeile %1 kein gültiges XML.</translation>
    </message>
    <message>
        <source>Check that it is complete, and look for a missing bracket or quote there.</source>
        <translation>Prüfen Sie, ob sie vollständig ist, und suchen Sie dort nach einer fehlenden Klammer oder einem Anführungszeichen.</translation>
    </message>
    <message>
        <source>The XML file is nested too deeply.</source>
        <translation>Die XML-Datei ist zu tief geschachtelt.</translation>
    </message>
    <message>
        <source>Give a file that is nested at most %1 deep.</source>
        <translation>Wählen Sie eine Datei, die höchstens %1 tief geschachtelt ist.</translation>
    </message>
    <message>
        <source>should have %1 numbers and has %2</source>
        <translation>sollte %1 Zahlen haben und hat %2</translation>
    </message>
    <message>
        <source>is not made of groups of %1</source>
        <translation>besteht nicht aus Gruppen von %1</translation>
    </message>
    <message>
        <source>is not sorted: %1 comes after %2</source>
        <translation>ist nicht sortiert: %1 kommt nach %2</translation>
    </message>
    <message>
        <source>holds &lt;%1&gt;, which no property list does</source>
        <translation>enthält &lt;%1&gt;, was keine Property List tut</translation>
    </message>
</context>
<context>
    <name>xr</name>
    <message>
        <source>The folder for pictures is not there.</source>
        <translation>Den Ordner für Bilder gibt es nicht.</translation>
    </message>
    <message>
        <source>Make it, or choose another one.</source>
        <translation>Legen Sie ihn an, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>The folder for pictures is full of them.</source>
        <translation>Der Ordner für Bilder ist voll davon.</translation>
    </message>
    <message>
        <source>Empty it, or choose another one.</source>
        <translation>Leeren Sie ihn, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>The picture could not be written.</source>
        <translation>Das Bild konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>There is not enough memory for the picture.</source>
        <translation>Für das Bild ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>The headset does not say where the eyes are, or what they see.</source>
        <translation>Das Headset sagt nicht, wo die Augen sind oder was sie sehen.</translation>
    </message>
    <message>
        <source>Put the headset on, and restart its software if that does not help.</source>
        <translation>Setzen Sie das Headset auf, und starten Sie seine Software neu, wenn das nicht hilft.</translation>
    </message>
    <message>
        <source>The headset asks for a picture of 170 degrees or more.</source>
        <translation>Das Headset verlangt ein Bild von 170 Grad oder mehr.</translation>
    </message>
    <message>
        <source>Restart the software of the headset.</source>
        <translation>Starten Sie die Software des Headsets neu.</translation>
    </message>
    <message>
        <source>Update the software of the headset.</source>
        <translation>Aktualisieren Sie die Software des Headsets.</translation>
    </message>
    <message>
        <source>The software of the headset does not answer as OpenXR 1.0 demands.</source>
        <translation>Die Software des Headsets antwortet nicht, wie es OpenXR 1.0 verlangt.</translation>
    </message>
    <message>
        <source>Update or reinstall it.</source>
        <translation>Aktualisieren Sie sie, oder installieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The OpenXR loader is not installed, so no headset can be found.</source>
        <translation>Der Loader von OpenXR ist nicht installiert, daher kann kein Headset gefunden werden.</translation>
    </message>
    <message>
        <source>Install it (Debian/Ubuntu: sudo apt install libopenxr-loader1).</source>
        <translation>Installieren Sie ihn (Debian/Ubuntu: sudo apt install libopenxr-loader1).</translation>
    </message>
    <message>
        <source>In a headset only path-traced pictures can be shown.</source>
        <translation>In einem Headset können nur Bilder mit Pfadverfolgung gezeigt werden.</translation>
    </message>
    <message>
        <source>Choose the cinematic or the clear look.</source>
        <translation>Wählen Sie die Darstellung Cinematic oder Klar.</translation>
    </message>
    <message>
        <source>These lights hang on the camera, and in a headset there are two eyes.</source>
        <translation>Diese Beleuchtung hängt an der Kamera, und in einem Headset gibt es zwei Augen.</translation>
    </message>
    <message>
        <source>Choose lights that stay in place; macula presets lists them.</source>
        <translation>Wählen Sie eine Beleuchtung, die an ihrem Ort bleibt; macula presets zählt sie auf.</translation>
    </message>
    <message>
        <source>Nothing of this study can be seen.</source>
        <translation>Von dieser Studie ist nichts zu sehen.</translation>
    </message>
    <message>
        <source>Choose another preset, or another clip.</source>
        <translation>Wählen Sie eine andere Voreinstellung oder einen anderen Beschnitt.</translation>
    </message>
    <message>
        <source>The OpenXR runtime that XR_RUNTIME_JSON names cannot be loaded.</source>
        <translation>Die OpenXR-Runtime, die XR_RUNTIME_JSON nennt, kann nicht geladen werden.</translation>
    </message>
    <message>
        <source>Correct or unset XR_RUNTIME_JSON.</source>
        <translation>Berichtigen oder entfernen Sie XR_RUNTIME_JSON.</translation>
    </message>
    <message>
        <source>The software of the headset cannot show pictures made with Vulkan (XR_KHR_vulkan_enable2).</source>
        <translation>Die Software des Headsets kann keine Bilder zeigen, die mit Vulkan gemacht sind (XR_KHR_vulkan_enable2).</translation>
    </message>
    <message>
        <source>Update it, or use another OpenXR runtime.</source>
        <translation>Aktualisieren Sie sie, oder verwenden Sie eine andere OpenXR-Runtime.</translation>
    </message>
    <message>
        <source>The headset does not say how large its pictures are.</source>
        <translation>Das Headset sagt nicht, wie groß seine Bilder sind.</translation>
    </message>
    <message>
        <source>The headset needs another version of Vulkan.</source>
        <translation>Das Headset braucht eine andere Version von Vulkan.</translation>
    </message>
    <message>
        <source>This headset cannot show the room behind the anatomy.</source>
        <translation>Dieses Headset kann den Raum hinter der Anatomie nicht zeigen.</translation>
    </message>
    <message>
        <source>The headset takes no pictures of 8 bits in sRGB (R8G8B8A8_SRGB).</source>
        <translation>Das Headset nimmt keine Bilder mit 8 Bit in sRGB (R8G8B8A8_SRGB).</translation>
    </message>
    <message>
        <source>The headset has ended the session: it was unplugged or fell asleep.</source>
        <translation>Das Headset hat die Sitzung beendet: es wurde ausgesteckt oder ist eingeschlafen.</translation>
    </message>
    <message>
        <source>Wake it up or plug it in, and begin again; nothing that was chosen is lost.</source>
        <translation>Wecken Sie es, oder stecken Sie es ein, und beginnen Sie noch einmal; nichts, was gewählt war, ist verloren.</translation>
    </message>
    <message>
        <source>The software of the headset has stopped.</source>
        <translation>Die Software des Headsets hat angehalten.</translation>
    </message>
    <message>
        <source>Start it again, and begin again; nothing that was chosen is lost.</source>
        <translation>Starten Sie sie wieder, und beginnen Sie noch einmal; nichts, was gewählt war, ist verloren.</translation>
    </message>
    <message>
        <source>It is begun again.</source>
        <translation>Sie wird noch einmal begonnen.</translation>
    </message>
    <message>
        <source>No software of a headset (OpenXR runtime) answers.</source>
        <translation>Keine Software eines Headsets (OpenXR-Runtime) antwortet.</translation>
    </message>
    <message>
        <source>Start SteamVR, Monado or what came with the headset, and make it the active OpenXR runtime.</source>
        <translation>Starten Sie SteamVR, Monado oder was dem Headset beilag, und machen Sie es zur aktiven OpenXR-Runtime.</translation>
    </message>
    <message>
        <source>No headset is connected, or it is switched off.</source>
        <translation>Kein Headset ist angeschlossen, oder es ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>Connect the headset, switch it on, and try again.</source>
        <translation>Schließen Sie das Headset an, schalten Sie es ein, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The OpenXR runtime knows no headsets.</source>
        <translation>Die OpenXR-Runtime kennt keine Headsets.</translation>
    </message>
    <message>
        <source>Make the runtime of the headset the active one.</source>
        <translation>Machen Sie die Runtime des Headsets zur aktiven.</translation>
    </message>
    <message>
        <source>There is not enough memory for the headset.</source>
        <translation>Für das Headset ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>The headset could not %1.</source>
        <translation>Das Headset konnte dies nicht: %1.</translation>
    </message>
    <message>
        <source>This build of Macula knows no headsets.</source>
        <translation>Diese Fassung von Macula kennt keine Headsets.</translation>
    </message>
    <message>
        <source>Build it with the package libopenxr-dev installed.</source>
        <translation>Bauen Sie sie, während das Paket libopenxr-dev installiert ist.</translation>
    </message>
    <message>
        <source>%1: %2 frames in %3 s, %4 a second; %5 without pictures.</source>
        <translation>%1: %2 Bilder in %3 s, %4 in der Sekunde; %5 davon leer.</translation>
    </message>
    <message>
        <source>This clip cannot be kept with the study.</source>
        <translation>Dieser Beschnitt kann nicht mit der Studie behalten werden.</translation>
    </message>
    <message>
        <source>Reset the clips, and cut again.</source>
        <translation>Setzen Sie den Beschnitt zurück, und schneiden Sie noch einmal.</translation>
    </message>
</context>
</TS>
