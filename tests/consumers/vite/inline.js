import 'hearth-fire/inline';
